#!/usr/bin/env python3
"""Follows the memory of a process and of all that it starts, five times a second, until it ends.

    memory.py PROCESS FILE

Each line of FILE holds two numbers in kB: the most that the largest of the processes has held so far, and what all of them hold
together; what several of them share is counted once for each."""
import os
import re
import sys
import time

largest_so_far = re.compile(r"^VmHWM:\s*(\d+)", re.MULTILINE)
held = re.compile(r"^VmRSS:\s*(\d+)", re.MULTILINE)


def descendants(ancestor):
    children = {}
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat") as stat:
                parent = int(stat.read().rpartition(")")[2].split()[1])
        except OSError:
            continue  # it has ended
        children.setdefault(parent, []).append(int(name))
    family = [ancestor]
    for one in family:
        family += children.get(one, [])
    return [one for one in family if one != os.getpid()]


def memory(process):
    try:
        with open(f"/proc/{process}/status") as status:
            text = status.read()
    except OSError:
        return 0, 0
    return tuple(int(found[1]) if (found := line.search(text)) else 0 for line in (largest_so_far, held))


def main():
    process, file = int(sys.argv[1]), sys.argv[2]
    with open(file, "w", buffering=1) as lines:
        while os.getppid() == process:  # whoever started us is the one to follow
            all_of_them = [memory(one) for one in descendants(process)]
            lines.write(f"{max(largest for largest, _ in all_of_them)} {sum(now for _, now in all_of_them)}\n")
            time.sleep(0.2)


if __name__ == "__main__":
    main()
