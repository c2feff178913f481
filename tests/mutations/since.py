"""What has changed since ./course test --exhaustive last held: the one line of tests/exhaustive.txt begins with the commit that was
tested then."""
import subprocess


def commit_held(file):
    """The first word of the file's first line that is no remark; none where there is no such file or line."""
    lines = file.read_text().splitlines() if file.exists() else []
    words = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return words[0][0] if words else ""


def changed_since_held(root):
    """The files below `root` that differ from that commit, as paths, committed or not; None where nobody knows: no commit is
    named, git isn't there, or it doesn't have that commit."""
    commit = commit_held(root / "tests/exhaustive.txt")
    if not commit:
        return None
    names = []
    for words in ["diff", "--name-only", "--relative", "--no-renames", commit, "--"], ["ls-files", "--others", "--exclude-standard"]:
        try:
            done = subprocess.run(["git", "-C", root, *words], text=True, capture_output=True)
        except OSError:
            return None
        if done.returncode:
            return None
        names += done.stdout.splitlines()
    return {root / name for name in names}
