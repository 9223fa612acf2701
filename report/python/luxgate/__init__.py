"""luxgate checks lighting designs: illuminance with confidence intervals, judged against what is required.

    import luxgate
    result = luxgate.check("office.xml")
    for finding in result.findings:
        print(finding.space, finding.plane, finding.words, finding.verdict, finding.measured)

`result.verdict` is what the whole design came to. A result is never true or false: "undecided", "not judged" and
"nothing asked" are no pass. See README.md of the module.
"""
import os

from . import _luxgate
from ._parts import Aggregate, Estimate, Finding, Message, Outcome, Part, Plane, Project, Verdict
from ._settings import explain as _explain
from ._settings import settings as _options

__version__ = version = _luxgate.version
numbers_version = _luxgate.numbers_version

__all__ = ["Aggregate", "CheckError", "Error", "Estimate", "Finding", "Message", "Outcome", "Part", "Plane", "Project",
           "Result", "SettingError", "Verdict", "check", "formats", "numbers_version", "read", "schema", "validate",
           "version"]


class Error(Exception):
    """Whatever luxgate cannot do."""


class SettingError(Error, ValueError):
    """A keyword has a value that it cannot have."""


class CheckError(Error):
    """A project, or a file that it needs, cannot be read or calculated, so that nothing is judged.

    messages: what is wrong, errors and warnings, with file, line, column, id and text.
    result: the Result that says so, for reports; None where there is none."""

    def __init__(self, messages, result=None):
        self.messages = tuple(messages)
        self.result = result
        errors = [message for message in self.messages if message.severity == "error"]
        super().__init__("\n".join(str(message) for message in errors or self.messages) or "nothing is judged")

    def __reduce__(self):
        return CheckError, (self.messages, self.result)


class Result:
    """What a check found. Made by check() and read()."""

    def __init__(self, document, messages=()):
        self._document = document
        self._parts = None
        self._run_messages = tuple(messages)

    @property
    def _all(self):
        if self._parts is None:
            parts = self._document.parts()
            for project in parts.projects:
                _name_places(project)
            self._parts = parts
        return self._parts

    @property
    def verdict(self):
        """Outcome of everything together, the gravest."""
        return Outcome(self._document.outcome())

    @property
    def exit_code(self):
        """That of `luxgate check`: 0 met, 1 not met, 2 not judged or a strict warning, 3 undecided."""
        return self._document.exit_code()

    @property
    def project(self):
        """The project; an Error if a result file has several."""
        if len(self.projects) != 1:
            raise Error(f"the result has {len(self.projects)} projects; see projects")
        return self.projects[0]

    @property
    def projects(self):
        """Projects: one, but of result files."""
        return self._all.projects

    @property
    def provenance(self):
        """How the result came about: version, seed, confidence, command."""
        return self._all.provenance

    @property
    def counts(self):
        """How many requirements have which verdict."""
        return self._all.counts

    @property
    def spaces(self):
        """Rooms, and the open space."""
        return tuple(space for project in self.projects for space in project.spaces)

    @property
    def planes(self):
        """Calculation planes of all spaces."""
        return tuple(plane for space in self.spaces for plane in space.planes)

    @property
    def findings(self):
        """Requirements of planes with their verdicts. See aggregates, too."""
        return tuple(finding for plane in self.planes for finding in plane.findings)

    @property
    def aggregates(self):
        """Requirements that are made of several: classes, shares, sums over buildings."""
        return tuple(aggregate for project in self.projects for aggregate in project.aggregates)

    @property
    def luminaires(self):
        """Types of luminaires; where each of them hangs is in the spaces."""
        return tuple(row for project in self.projects for row in project.luminaires)

    @property
    def messages(self):
        """Warnings and errors, about the project and about the run."""
        return self._run_messages + tuple(message for project in self.projects for message in project.diagnostics)

    def render(self, format, **style):
        """The text of a report; format is one of formats(), but "xlsx", which is no text: write() writes it."""
        rendered = self._bytes("render", format, style)
        try:
            return rendered.decode("cp1252" if format == "dxf" else "utf-8")  # as the drawing's code page says
        except UnicodeDecodeError:
            raise SettingError(f"format '{format}': this is no text; write() writes it") from None

    def write(self, format, path, **style):
        """Writes a report, whole or not at all; format is one of formats(). OSError where it cannot be written, or was read for the result."""
        if os.path.exists(path) and any(os.path.exists(file) and os.path.samefile(path, file) for file in self._inputs()):
            raise OSError(f"'{path}' was read as an input and is not overwritten")
        problem = _luxgate.write(_path(path), self._bytes("write", format, style))
        if problem:
            raise OSError(f"cannot write '{path}': {problem}")

    def _inputs(self):
        """Files that were read, as far as they are known: names are the project's own, from its folder."""
        for project in self.projects:
            yield project.path
            for file in project.inputs:
                yield os.path.join(os.path.dirname(project.path), file.path)

    def to_json(self):
        """The result file, to the byte what `luxgate check --format json` writes."""
        return self.render("json")

    def _bytes(self, function, format, style):
        rendered, problem = self._document.render(format, _options(function, "write", style))
        if problem:
            raise SettingError(problem)
        return rendered

    def __reduce__(self):
        return _parsed, (self.to_json(), self._run_messages)

    def __bool__(self):
        raise TypeError("a Result is not true or false; compare: result.verdict == luxgate.Outcome.PASS")

    def __repr__(self):
        names = ", ".join(repr(project.path) for project in self.projects)
        counts = self.counts.to_dict().items()
        return f"<luxgate.Result {names}: {self.verdict}; " + ", ".join(f"{n} {key}" for key, n in counts if n) + ">"


def _name_places(project):
    """Planes and findings know where they are: results are walked flat, too."""
    for space in project.spaces:
        for plane in space.planes:
            plane.__dict__["space"] = space.id
            for finding in plane.findings:
                finding.__dict__.update(project=project.path, space=space.id, plane=plane.id)


def _path(path):
    return os.fsdecode(os.fspath(path))


def _checked(raised):
    document, messages, problem = raised
    if problem:
        raise SettingError(problem)
    if document is None:
        raise CheckError(messages)
    return Result(document, messages)


def _parsed(json, messages):
    document, problems, _ = _luxgate.parse(json)
    return _checked((document, problems if document is None else messages, ""))


def check(path, **settings):
    """Calculates a project and judges its requirements: what `luxgate check` does, with the same bits.

    Raises CheckError if the project cannot be read or calculated. A plane that cannot be judged is no exception: its
    findings are not judged, and so is the result. Other threads go on meanwhile; Ctrl-C ends it within moments.
    """
    result = _checked(_luxgate.check(_path(path), _options("check", "check", settings)))
    if not result._document.is_judged():
        raise CheckError(result.messages, result)
    return result


def validate(path, **settings):
    """Finds errors, and what will not be judged, without calculating. Returns messages, none if there are none."""
    document, messages, problem = _luxgate.validate(_path(path), _options("validate", "validate", settings))
    if problem:
        raise SettingError(problem)
    return tuple(messages) if document is None else Result(document, messages).messages


def read(path):
    """The Result of a file that `check --format json` or Result.write("json") wrote; judged again, and refused with a
    CheckError where it contradicts itself."""
    return _checked(_luxgate.read(_path(path)))


def formats():
    """Names of formats for Result.write() and render()."""
    return tuple(_luxgate.formats())


def schema(of="project"):
    """The XML schema of project files, or of="result": the JSON schema of results."""
    if of == "project":
        return _luxgate.project_schema()
    if of == "result":
        return _luxgate.result_schema()
    raise ValueError(f"there is no schema of '{of}'; there are project and result")


_explain(check, "check")
_explain(validate, "validate")
_explain(Result.render, "write")
_explain(Result.write, "write")
