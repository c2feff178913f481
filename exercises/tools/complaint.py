"""A mistake in what somebody wrote: said in sentences, without a trace of the program."""


class Complaint(Exception):
    """Names the offending value and the rule that it breaks."""
