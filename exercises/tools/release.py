"""./course release DIR: a student's copy of the course, without solutions, wrong answers and notes for instructors.

It builds and tests on its own. MANIFEST.json lists its exercises and the SHA-256 of each file. --bundle adds the headers of Eigen and
doctest with their licences, for machines on which nothing can be installed. Nothing is written if anything of a solution is left in it.
"""

import ctrl_c  # noqa: F401
import argparse
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

from catalogue import read_catalogue
from command import status_of
from complaint import Complaint
from outputs import occupy_standard_descriptors
from plain_text import one_line, say
from starter import regions_of
from toolchain import read_toolchain

LEFT_OUT = re.compile(r"(solutions|work|build|third_party)/|tests/exercises/(?!CMakeLists|judge_checks|tools/(run|test_|gradescope_format))|"
                      r"(.*/)?(instructor[^/]*|node_modules|__pycache__)(/|$)|MANIFEST\.json$", re.IGNORECASE)
LICENCES = {"eigen3.txt": "/usr/share/doc/libeigen3-dev/copyright", "doctest.txt": "/usr/share/doc/doctest-dev/copyright",
            "MPL-2.0.txt": "/usr/share/common-licenses/MPL-2.0"}
LEAST = 12  # letters and signs of a region that can be recognised


def git(root, *words):
    """What git prints. What else a caller's environment says of it, as in one of its hooks, is about another checkout."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    try:
        return subprocess.run(["git", "--no-optional-locks", "-c", f"safe.directory={os.path.realpath(root)}", "-C", str(root), *words],
                              stdin=subprocess.DEVNULL, capture_output=True, check=True, env=environment).stdout
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        said = os.fsdecode(error.stderr).strip() if isinstance(error, subprocess.CalledProcessError) else "git is not installed"
        raise Complaint(f"git has no commit of {root}, so nobody can tell what belongs to the course from what else lies there ({said}). "
                        "Where the course came without git: git init, git add of what belongs to it, and git commit") from None


def not_committed(root):
    """What lies there otherwise than in the last commit, and why no release has it so."""
    listed = git(root, "status", "--porcelain", "-z", "--no-renames", "--untracked-files=normal", "--", ".")
    names = [os.fsdecode(entry[3:]) for entry in listed.split(b"\0") if entry]
    return {name: "it is not committed as it is here" for name in names if not LEFT_OUT.match(name)}


def copy_commit(root, folder):
    """Copies what students get of the last commit. Returns what is left out although somebody might miss it: by its name, why."""
    left_out = {}
    with tarfile.open(fileobj=io.BytesIO(git(root, "-c", "core.autocrlf=false", "archive", "HEAD^{tree}")), mode="r:") as archive:
        members = [member for member in archive if not member.isdir() and not LEFT_OUT.match(member.name)]
        private = _private_folders([member.name for member in members])
        for member in members:
            if member.name.startswith(private):
                left_out[member.name] = "it belongs to a private folder, such as grade --private takes"
            elif not member.isfile():
                left_out[member.name] = "it is a symbolic link"
            elif any("\udc80" <= letter <= "\udcff" for letter in member.name):
                left_out[member.name] = "its name is not UTF-8, so neither MANIFEST.json nor a zip can hold it"
            else:
                file = folder / member.name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(archive.extractfile(member).read())
                file.chmod(0o755 if member.mode & 0o100 else 0o644)
    if not folder.exists():
        raise Complaint(f"the last commit of {root} holds nothing; git add and git commit of what belongs to the course say what is released")
    return left_out


def _private_folders(tracked):
    """Where exercises lie that are neither the course's own nor those of its tests; at the root, the folder of each alone."""
    found = [re.fullmatch(r"((?:.*/)?)([0-9]{2}_[a-z0-9_]+/[a-z][a-z0-9_]*/)exercise\.json", name, re.DOTALL) for name in tracked]
    return tuple({each[1] or each[2] for each in found if each and each[1] != "exercises/" and not each[1].startswith("tests/")})


def tell_left_out(left_out):
    for name, why in left_out.items():
        say(f"Left out: {one_line(name)} ({why})")


def what_is_left_of_solutions(root, folder, catalogue):
    """Complaints about everything in the folder that gives a solution away. Hints may: they are there to be asked for."""
    regions = []
    for exercise in catalogue:
        solution = root / "solutions" / exercise.path / exercise.header
        if not solution.exists():
            raise Complaint(f"{solution} is missing, so nobody can tell whether anything of it is left in the release")
        for region in regions_of(solution.read_text(encoding="utf-8"), str(solution)):
            bare = _bare(region)
            if len(bare) >= LEAST:
                regions.append((exercise.path, bare))
    complaints = []
    for file in sorted(folder.rglob("*")):
        name = str(file.relative_to(folder))
        if {"solutions", "wrong.txt"} & set(Path(name.lower()).parts):
            complaints.append(f"{name} lies where solutions and wrong answers do")
        if not file.is_file() or name.startswith(("chapters/", "common/", "exact/", "third_party/")) or file.name == "hints.md":
            continue
        text = file.read_text(encoding="utf-8", errors="replace")
        if file.suffix in (".hpp", ".cpp") and re.search(r"//!\s*\[solution\]", text):
            complaints.append(f"{name} holds the mark of a solution")
        bare = _bare(text)
        complaints += [f"{name} holds a part of the solution of {path}" for path, region in regions if region in bare]
    return complaints


def _bare(text):
    """Without comments and blanks: how it is laid out doesn't matter."""
    return re.sub(r"\s+", "", re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL))


def bundle(folder, toolchain_file):
    """third_party/, in which CMake looks first."""
    system_folders = read_toolchain(toolchain_file, "", Path(toolchain_file).parent).system_folders
    eigen = next((Path(place) for place in system_folders if (Path(place) / "Eigen" / "Core").exists()), None)
    doctest = next((place for place in map(Path, ("/usr", "/usr/local")) if (place / "include/doctest/doctest.h").exists()), None)
    if not eigen or not doctest:
        raise Complaint(f"the headers of {'doctest' if eigen else 'Eigen'} were not found, so they can't be bundled")
    third = folder / "third_party"
    # Eigen's CMake files find its headers from where they lie themselves.
    shutil.copytree(eigen / "Eigen", third / "include" / "eigen3" / "Eigen")
    shutil.copytree(eigen.parents[1] / "share" / "eigen3" / "cmake", third / "share" / "eigen3" / "cmake")
    (third / "include" / "doctest").mkdir(parents=True)
    shutil.copyfile(doctest / "include" / "doctest" / "doctest.h", third / "include" / "doctest" / "doctest.h")
    shutil.copytree(doctest / "lib" / "cmake" / "doctest", third / "lib" / "cmake" / "doctest")
    (third / "licences").mkdir()
    for name, source in LICENCES.items():
        if not Path(source).exists():
            raise Complaint(f"{source} is missing; nothing is bundled without its licence")
        shutil.copyfile(source, third / "licences" / name)


def write_manifest(folder, catalogue):
    files = {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
             for file in sorted(folder.rglob("*")) if file.is_file()}
    exercises = [{"exercise": exercise.path, "title": exercise.title, "points": exercise.points, "minutes": exercise.minutes}
                 for exercise in catalogue]
    (folder / "MANIFEST.json").write_text(json.dumps({"exercises": exercises, "files": files}, indent=1, ensure_ascii=False) + "\n",
                                          encoding="utf-8")
    return len(files)


def release(root, target, toolchain_file=None):
    """Makes the release, complete or not at all; with a toolchain's file, bundled. Returns how many files it holds, and what it leaves
    out: by its name, why."""
    target = Path(os.path.realpath(target))  # of a link, what it leads to
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise Complaint(f"{target} is there already and not empty; name a folder that is not there yet")
    if target.is_relative_to(root.resolve()):
        raise Complaint(f"{target} lies inside the course; a release of it would hold itself")
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent, prefix=".release-") as scratch:
        folder = Path(scratch) / "course"
        left_out = {**not_committed(root), **copy_commit(root, folder)}
        catalogue = read_catalogue(folder)  # and not the root's: an exercise that isn't committed isn't even named
        if toolchain_file:
            bundle(folder, toolchain_file)
        complaints = what_is_left_of_solutions(root, folder, catalogue)
        if complaints:
            raise Complaint("nothing is released, for a solution shows:\n  " + "\n  ".join(complaints))
        count = write_manifest(folder, catalogue)
        if target.exists():
            target.rmdir()
        os.replace(folder, target)
    return count, left_out


def main(words):
    occupy_standard_descriptors()
    parser = argparse.ArgumentParser(prog="./course release", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--toolchain", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("folder", type=Path, metavar="DIR")
    parser.add_argument("--bundle", action="store_true", help="add the headers of Eigen and doctest, with their licences")
    arguments = parser.parse_args(words)

    def run():
        count, left_out = release(arguments.root, arguments.folder, arguments.toolchain if arguments.bundle else None)
        say(f"{count} files are in {arguments.folder}; MANIFEST.json lists them.")
        tell_left_out(left_out)
    return status_of(run)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
