"""What a build folder knows: how each chapter's check files are compiled, and with what they are linked."""
import json
import re
import shlex
from pathlib import Path

from mutation_list import ListError


class Build:
    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.commands = {}  # by chapter, then by the file's name without _checks.cpp: (directory, words, file)
        self.others = {}  # by chapter, then by file: what else its checks are linked with: (object, words, file)
        self.main = self.main_words = None
        path = self.folder / "compile_commands.json"
        if not path.exists():
            raise ListError(f"{path} does not exist; configure the build with CMAKE_EXPORT_COMPILE_COMMANDS")
        for entry in json.loads(path.read_text()):
            # What the course compiles once for many programs is compiled here with the mutation in it.
            words = [word for word in shlex.split(entry["command"]) if not word.startswith("-DTUMBLE_COMPILED_")]
            file, target = Path(entry["file"]), words.index("-o") + 1
            if file.name == "check_main.cpp":
                self.main, self.main_words = Path(entry["directory"], words[target]), words[:target - 1]
            elif file.name.endswith("_checks.cpp"):
                checks = self.commands.setdefault(file.parent.name, {})
                checks[file.name.removesuffix("_checks.cpp")] = (entry["directory"], words[:target - 1], file)
            elif re.search(r"\btumble_(rungs|scenes_folder)\.dir\b", words[target]):
                self.others.setdefault(file.parent.name, {})[file.stem] = (
                    Path(entry["directory"], words[target]), words[:target - 1], file)
        if self.main is None or not self.main.exists():
            raise ListError(f"{self.main} does not exist; build the targets tumble_check_main and tumble_check_headers")

    def chapters(self):
        """Those with headers, in order."""
        return sorted(name for name in self.commands if re.match(r"\d\d_", name))

    def rooms(self):
        """Whose checks may see what changes a header below, in order: the chapters, and the tools that stand on them."""
        return [*self.chapters(), *(name for name in ("bench", "scene_reader") if name in self.commands)]

    def checks(self, chapter):
        if chapter not in self.commands:
            raise ListError(f"no chapter with checks is called {chapter}; there are {', '.join(self.commands)}")
        return self.commands[chapter]

    def header(self, chapter, name):
        """The path of a header that the chapter's checks can include, or None."""
        for _, words, _ in self.checks(chapter).values():
            path = find_header(name, include_folders(words))
            if path:
                return path
        return None


def launcher_of(folder):
    """What starts the compiler there, as words: ccache where it is installed, so that a run that was stopped goes on quickly."""
    said = Path(folder, "exercises", "toolchain.json")
    return [word for word in json.loads(said.read_text())["launcher"] if word] if said.exists() else []


def include_folders(words):
    return [Path(word[2:]) for word in words if word.startswith("-I")]


def find_header(name, folders):
    return next((folder / name for folder in folders if (folder / name).exists()), None)


def headers_of(file, folders, found=None):
    """The headers of ours that `file` includes, itself or by way of others."""
    found = set() if found is None else found
    for name in re.findall(r"#include <((?:tumble|support)/[\w/]+\.hpp)>", file.read_text()):
        path = find_header(name, folders)
        if path and path not in found:
            found.add(path)
            headers_of(path, folders, found)
    return found
