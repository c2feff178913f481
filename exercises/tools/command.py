"""How a command ends: what went wrong is told in a sentence, and becomes the exit status."""

from complaint import Complaint, GraderFailed
from made import CommandFailed
from plain_text import complain, why_unheard
from shards import Stopped, stoppable

WRONG, NO_RESULT = 2, 3


def status_of(work):
    """What the work returns, 0 for nothing, or how it failed."""
    try:
        with stoppable():
            return work() or 0
    except Complaint as complaint:
        complain(complaint)
        return WRONG
    except GraderFailed as failure:
        complain(failure)
        return NO_RESULT
    except CommandFailed as failure:  # what is compiled without any of a student's code
        complain(f"the course's own code, or a check, doesn't compile:\n{failure.output}")
        return WRONG
    except Stopped as stopped:
        return 128 + stopped.signal
    except OSError as error:
        return why_unheard(error)
