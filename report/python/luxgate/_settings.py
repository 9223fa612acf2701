"""Keywords as the program's own options: their names, values, checks and words are said there, once."""
import functools
import inspect
import os

from . import _luxgate


@functools.lru_cache(maxsize=None)
def offered(use):
    """Options by keyword: {"max_paths": ("--max-paths", "N", help, is_flag, may_have_value, repeats)}"""
    return {row[0].lstrip("-").replace("-", "_"): row for row in _luxgate.options(use)}


def _text(keyword, value):
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    # numpy's numbers, too; an array is none.
    if isinstance(value, bool) or not hasattr(value, "__float__") or getattr(value, "ndim", 0):
        raise TypeError(f"{keyword}: a text or a number is needed, not {type(value).__name__}")
    return str(value)


def _pair(keyword, key, value):
    text = str(value).lower() if isinstance(value, bool) else _text(keyword, value)
    return f"{key}={text}"


def _texts(keyword, value, row):
    _, _, _, is_flag, may_have_value, repeats = row
    if is_flag or (may_have_value and isinstance(value, bool)):
        if not isinstance(value, bool):
            raise TypeError(f"{keyword}: True or False is needed, not {type(value).__name__}")
        return [""] if value else []
    if isinstance(value, dict):
        if not repeats:
            raise TypeError(f"{keyword}: one value is needed, not a dictionary")
        return [_pair(keyword, key, one) for key, one in value.items()]
    if isinstance(value, (list, tuple, set, frozenset)):
        texts = [_text(keyword, one) for one in value]
        if may_have_value:
            return [",".join(texts)] if texts else []
        if not repeats:
            raise TypeError(f"{keyword}: one value is needed, not {len(texts)}")
        return texts
    text = _text(keyword, value)
    if may_have_value and not text:
        raise ValueError(f"{keyword}: True, or ids")
    return [text]


def settings(function, use, keywords):
    """[(option, text)] of keywords. None is as if it was not given."""
    known = offered(use)
    pairs = []
    for keyword, value in keywords.items():
        if keyword not in known:
            option = "--" + keyword.replace("_", "-")
            if option in _luxgate.known_options():
                raise TypeError(f"{function}() has no keyword '{keyword}'; {option} is there on the command line only")
            raise TypeError(f"{function}() has no keyword '{keyword}'" + _luxgate.suggestion(keyword, list(known)))
        if value is None:
            continue
        row = known[keyword]
        pairs += [(row[0], text) for text in _texts(keyword, value, row)]
    return pairs


def explain(function, use):
    """Gives a function of keywords the signature and the words of its options."""
    lines = [inspect.cleandoc(function.__doc__), "", "Keywords; None is as if it was not given:"]
    parameters = [parameter for parameter in inspect.signature(function).parameters.values()
                  if parameter.kind is not inspect.Parameter.VAR_KEYWORD]
    for keyword, (_, value_name, words, *_) in offered(use).items():
        lines += ["", f"{keyword}{': ' + value_name if value_name else ''}"]
        lines += ["    " + line for line in words.split("\n")]
        parameters.append(inspect.Parameter(keyword, inspect.Parameter.KEYWORD_ONLY, default=None))
    function.__doc__ = "\n".join(lines)
    function.__signature__ = inspect.Signature(parameters)
    return function
