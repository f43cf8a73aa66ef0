"""Small changes of C code that a test should notice: where they are possible, and the text that each gives."""
import re
import typing

# Nothing in comments, strings, characters and preprocessor lines is changed.
HIDDEN = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
OPERAND = r"[\w)\]]"

# name, what is searched for (group 1 is replaced), replacements
OPERATORS = (
    ("border", rf"{OPERAND} (<=|>=|<|>) ", {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}),
    ("flip", rf"{OPERAND} (<=|>=|<|>|==|!=) ", {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}),
    ("sign", rf"{OPERAND} (\+|-) ", {"+": "-", "-": "+"}),
    ("negate", r"(?:[=(,?:] |\(|return )(-)(?=[a-z])", {"-": ""}),
    ("step", rf"{OPERAND} (\+=|-=) ", {"+=": "-=", "-=": "+="}),
    ("shift", r"(?:<<|>>) (\d+)", None),
    ("one_off", r"(?:(?<![<>])[<>]=?|==|!=|[+-]=?) (\d+)(?=[;), ])", None),
    ("logic", rf"{OPERAND} (&&|\|\|) ", {"&&": "||", "||": "&&"}),
    ("not", r"(?:\(|&& |\|\| |return )(!)(?=\w)", {"!": ""}),
    ("drop_term", rf"{OPERAND}( [+-] \w+(?:\.\w+|->\w+|\[\w+\])*)(?=[;),])", lambda text: ""),
)


class Mutant(typing.NamedTuple):
    file: str      # below the root
    line: int
    operator: str
    before: str    # the line, without white space around it
    after: str
    text: str      # of the whole file

    def key(self):
        """What names it whatever lines are added above it."""
        return self.file, self.before, self.after


def replacements(rule, found):
    if rule is None:
        return [str(int(found) + 1)] + ([str(int(found) - 1)] if int(found) > 0 else [])
    return [rule(found) if callable(rule) else rule[found]]


def mutants(file, text):
    """Every mutant of a file, in the order of its operators and lines."""
    code = HIDDEN.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)
    for operator, pattern, rule in OPERATORS:
        for match in re.finditer(pattern, code):
            start, end = match.span(1)
            for new in replacements(rule, match.group(1)):
                changed = text[:start] + new + text[end:]
                line = text.count("\n", 0, start)
                before, after = text.split("\n")[line].strip(), changed.split("\n")[line].strip()
                if before != after:
                    yield Mutant(file, line + 1, operator, before, after, changed)


def self_test():
    """Each operator changes what it says and nothing in comments and strings; returns what is wrong."""
    source = ("/* a < b, a + b, x >> 3 */\n#define LESS(a, b) (a < b)\nint f(int a, int b) {\n"
              "  const char *text = \"a < b\";\n  if (a <= b && !g(a)) return -a;\n  a += b;\n  return (a + b) >> 3;\n}\n")
    made = [(mutant.operator, mutant.line, mutant.after) for mutant in mutants("f.c", source)]
    expected = {("border", 5, "if (a < b && !g(a)) return -a;"), ("flip", 5, "if (a > b && !g(a)) return -a;"),
                ("logic", 5, "if (a <= b || !g(a)) return -a;"), ("not", 5, "if (a <= b && g(a)) return -a;"),
                ("negate", 5, "if (a <= b && !g(a)) return a;"), ("step", 6, "a -= b;"), ("sign", 7, "return (a - b) >> 3;"),
                ("drop_term", 7, "return (a) >> 3;"), ("shift", 7, "return (a + b) >> 4;"), ("shift", 7, "return (a + b) >> 2;")}
    return [f"missing: {item}" for item in expected - set(made)] + [f"not meant: {item}" for item in set(made) - expected]
