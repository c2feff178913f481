"""A mistake in what somebody wrote: said in sentences, without a trace of the program."""


class Complaint(Exception):
    """Names the offending value and the rule that it breaks."""


class GraderFailed(Exception):
    """The grader itself failed, so that nothing is known of what it graded: to be tried again, and never 0 points."""
