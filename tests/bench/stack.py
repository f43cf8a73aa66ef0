"""The most stack that a function of the core may take, from the compiler's call graphs (-fcallgraph-info=su,da); recursion is an error.

A call through a pointer is resolved by its source: `kind->shadow(...)` calls whatever stands in the place of `shadow` in a const descriptor
(kind.h, layer.h, ...). VISITORS and ALIASES have the exceptions.
"""
import collections
import functools
import pathlib
import re

from images import Failure

NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]+)")?')
MEMBER = re.compile(r"\(\*(\w+)\)\(")
DESCRIPTOR = re.compile(r"^const (fc_\w+) \w+ FC_ROM =\s+\{([^;]*)\};", re.M)
# The same by a macro, for kinds that differ in some members.
MACRO = re.compile(r"^#define (\w+)\(([\w, ]+)\)[ \\\n]*\{((?:[^\n]*\\\n)*[^\n]*)\}", re.M)
BY_MACRO = re.compile(r"^(const fc_\w+ \w+ FC_ROM =\s+)(\w+)\(([\w, ]+)\);", re.M)
# Pointers that are no members: a search calls any function of a visitor's form, fc_layers_apply one of three members.
# A sphere's coat is filled in where it is made.
VISITORS = {"visit": r"^[\w ]*\bbool (\w+)\(void \*context, const fc_cursor \*at, uint16_t index\) \{",
            **{member: rf"^[\w ]*\bvoid (ball_{member})\(" for member in ("start", "run", "seen")}}
ALIASES = {"act": ("surface", "light")}
# It runs once more below itself, for the surface in a mirror, whose own mirrors are followed by a loop: `follow` is called with the enumerator only.
TWICE = ("fc_layers_apply", "FC_LAYER_FOLLOW", "follow")


def without_comments(text):
    return re.sub(r"/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match.group()), text, flags=re.S)


class Sources:
    """What the C text says about calls through pointers."""

    def __init__(self, core):
        self.text = {path.name: without_comments(path.read_text(encoding="utf-8")) for path in sorted(core.glob("*.[ch]"))}
        order = {}
        for text in self.text.values():
            for name, body in re.findall(r"^struct (fc_\w+) \{\n(.*?)^\};", text, re.M | re.S):
                order[name] = MEMBER.findall(body)
        macros = {}
        for text in self.text.values():
            for name, parameters, body in MACRO.findall(text):
                macros[name] = (parameters.split(", "), body.replace("\\\n", " "))

        def expanded(match):
            if match.group(2) not in macros:
                return match.group()
            parameters, body = macros[match.group(2)]
            given = dict(zip(parameters, match.group(3).split(", ")))
            return f"{match.group(1)}{{{re.sub(r'[a-z_0-9]+', lambda word: given.get(word.group(), word.group()), body)}}};"

        self.targets = collections.defaultdict(set)
        for name, text in self.text.items():
            text = BY_MACRO.sub(expanded, text)
            for kind, values in DESCRIPTOR.findall(text):
                for member, value in zip(order.get(kind, ()), map(str.strip, values.split(","))):
                    if value != "NULL":
                        self.targets[member].add((name, value))
                        self.targets[kind, member].add((name, value))
            for member, pattern in VISITORS.items():
                for value in re.findall(pattern, text, re.M):
                    self.targets[member].add((name, value))
        for name, members in ALIASES.items():
            self.targets[name] = set().union(*(self.targets[member] for member in members))

    def called(self, place):
        """{(file, function)} that the call at FILE:LINE:COLUMN may reach."""
        path, line, _ = place.rsplit(":", 2)
        name = pathlib.Path(path).name
        lines = self.text[name].splitlines()
        text = " ".join(lines[int(line) - 1:int(line) + 2])
        for base, member in re.findall(r"(\w+)(?:\(\w*(?:->\w+|&\w+)*\))?(?:\.|->)(\w+)\(", text):
            # the type that the variable, or what the function returns, was last declared with
            declared = re.findall(rf"\b(fc_\w+) \*?{base}\b", self.text["kind.h"] + "\n".join(lines[:int(line)]))
            if declared and self.targets.get((declared[-1], member)):
                return self.targets[declared[-1], member]
        members = [member for member in re.findall(r"\b(\w+)\(", text) if member in self.targets]
        if not members:
            raise Failure(f"{name}:{line}: a call through a pointer that stands in no const descriptor; add it to VISITORS of stack.py")
        return self.targets[members[0]]


    def passes(self, title, function, enumerator):
        """Whether the body of a function of the graph calls another with an enumerator."""
        name = re.sub(r"\.\w+$", "", title.rsplit(":", 1)[-1])
        return any(re.search(rf"^[\w ]*[ *]{re.escape(name)}\([^;{{]*\{{(?:(?!^\}}).)*{function}\([^;]*{enumerator}", text, re.M | re.S)
                   for text in self.text.values())


class Graph:
    def __init__(self, graphs, core):
        self.frames, self.edges, self.owner, indirect = {}, collections.defaultdict(set), {}, []
        for path in graphs:
            for line in path.read_text(errors="replace").splitlines():
                node, edge = NODE.match(line), EDGE.match(line)
                if node:
                    name, size = node.group(1), re.search(r"(\d+) bytes \((\w+)", node.group(2))
                    if size:
                        if size.group(2) != "static":
                            raise Failure(f"{name} has a frame of no fixed size")
                        self.frames[name] = int(size.group(1))
                elif edge and edge.group(2) == "__indirect_call":
                    indirect.append((edge.group(1), edge.group(3)))
                elif edge:
                    self.edges[edge.group(1)].add(edge.group(2))
        sources = Sources(core)
        for caller, place in indirect:
            for name, function in sources.called(place):
                self.edges[caller].update(self.titles(name, function))

        function, enumerator, member = TWICE
        again = f"{function} ({member})"
        self.frames[again] = self.frames.get(function, 0)
        self.edges[again] = {title for name, target in sources.targets[member] for title in self.titles(name, target)}
        for title in [title for title in self.frames if sources.passes(title, function, enumerator)]:
            self.edges[title].add(again)

    def titles(self, name, function):
        """Its names in the graph: with the file when static, with a suffix when a copy was made."""
        return [title for title in self.frames
                if title == function or re.fullmatch(rf".*/{re.escape(name)}:{function}(\.\w+)*", title)]

    def keep(self, holds):
        """Drops what a program does not hold, by a question of a title."""
        self.frames = {title: size for title, size in self.frames.items() if holds(title.split(" (")[0])}
        self.edges = {title: {callee for callee in callees if callee in self.frames} for title, callees in self.edges.items()}

    def worst(self, root):
        """(bytes, path) of the deepest call from a function on; library functions without a record count 0."""
        open_calls = []

        @functools.lru_cache(maxsize=None)
        def depth(name):
            if name in open_calls:
                raise Failure(f"recursion: {' > '.join(map(short, open_calls[open_calls.index(name):] + [name]))}")
            open_calls.append(name)
            best = max((depth(callee) for callee in sorted(self.edges.get(name, ()))), default=(0, ()))
            open_calls.pop()
            return self.frames.get(name, 0) + best[0], (name, *best[1])

        if root not in self.frames:
            raise Failure(f"there is no function {root}")
        return depth(root)


def short(title):
    return title.rsplit("/", 1)[-1].replace(".c:", ":")
