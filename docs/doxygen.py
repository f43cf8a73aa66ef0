"""Doxygen's filter: a header whose plain comments are marked as documentation, /* before a declaration and after it on its line.

doxygen.py FILE
"""
import re
import sys

ESCAPED = str.maketrans({"@": "\\@", "\\": "\\\\", "<": "\\<", ">": "\\>", "#": "\\#", "%": "\\%", "&": "\\&"})


def marked(text):
    """The first comment describes the file, one with code before it on its line what stands there, others what follows."""
    def mark(match):
        before = text[text.rfind("\n", 0, match.start()) + 1:match.start()].strip()
        words = match.group(1).translate(ESCAPED)
        if match.start() == 0:
            return f"/** @file\n{words}*/"
        return f"/**{'<' if before else ''}{words}*/"

    return re.sub(r"/\*(.*?)\*/", mark, text, flags=re.S)


if __name__ == "__main__":
    sys.stdout.write(marked(open(sys.argv[1], encoding="utf-8").read()))
