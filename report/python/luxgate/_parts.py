"""What a result is made of. Classes, keys and names come from the program's own description of its result file."""
import enum
import keyword

import numpy

from . import _luxgate


class _Name(str, enum.Enum):
    """One of a few names. Equal to its text; a text that is none of the names is an error, not a quiet False."""

    def __str__(self):
        return self.value

    def __eq__(self, other):
        if isinstance(other, str) and not isinstance(other, _Name) and other not in type(self)._value2member_map_:
            raise ValueError(f"'{other}' is no {type(self).__name__}; there are "
                             + ", ".join(member.value for member in type(self)))
        return str.__eq__(self, other)

    def __ne__(self, other):
        return not self == other

    __hash__ = str.__hash__

    def __bool__(self):
        raise TypeError(f"a {type(self).__name__} is not true or false; compare it: == {type(self).__name__}.PASS")

    def __reduce_ex__(self, protocol):
        return type(self), (self.value,)


def _names(name, values, doc):
    members = [(value.upper().replace("-", "_"), value) for value in values]
    made = _Name(name, members, module="luxgate", qualname=name)
    made.__doc__ = doc
    return made


Verdict = _names("Verdict", _luxgate.verdicts(), "What became of one requirement.")
Outcome = _names("Outcome", _luxgate.outcomes(),
                 "What something came to as a whole, gravest first; only 'pass' is a pass.")


class Part:
    """A part of a result. Its attributes are the keys of the result file (`luxgate.schema("result")`): what a file
    leaves out is None, tables of numbers are read-only arrays, `pass`, `from` and `in` are `pass_`, `from_` and `in_`. Nothing
    can be changed."""

    def __setattr__(self, name, value):
        raise AttributeError(f"a result cannot be changed: {name}")

    def __delattr__(self, name):
        raise AttributeError(f"a result cannot be changed: {name}")

    def __getattr__(self, name):
        raise AttributeError(f"{type(self).__name__} has no '{name}'; it has " + ", ".join(self.__dict__))

    def to_dict(self):
        """The same as dictionaries, tuples, arrays and plain values."""
        return {key[:-1] if keyword.iskeyword(key[:-1]) else key: _plain(value) for key, value in self.__dict__.items()}

    def __repr__(self):
        shown = ", ".join(f"{key}={value!r}" for key, value in self.__dict__.items()
                          if isinstance(value, (str, int, float, Estimate)) and str(value))
        return f"<{type(self).__name__} {shown}>"

    def __reduce__(self):
        return make_part, (type(self).__name__, self.__doc__, dict(self.__dict__))


def _plain(value):
    if isinstance(value, Part):
        return value.to_dict()
    if isinstance(value, tuple):
        return tuple(_plain(item) for item in value)
    return value.value if isinstance(value, _Name) else value


def _not_a_truth(what):
    def fail(self):
        raise TypeError(f"a {type(self).__name__} is not true or false; ask for {what}")
    return fail


class Estimate(Part):
    def __repr__(self):
        return f"<{self.value} ({self.low} to {self.high})>"


class Finding(Part):
    __bool__ = _not_a_truth("verdict, or outcome, which knows waivers")


class Aggregate(Part):
    __bool__ = _not_a_truth("verdict, or outcome, which knows waivers")


class Project(Part):
    __bool__ = _not_a_truth("outcome")


class Message(Part):
    @property
    def file(self):
        return self.where.file

    @property
    def line(self):
        return self.where.line

    @property
    def column(self):
        return self.where.column

    @property
    def text(self):
        return self.message

    def __str__(self):
        return self.formatted


class Plane(Part):
    def _table(self):
        if not self.is_computed:
            from . import Error
            raise Error(f"plane '{self.id}' was not computed: {self.reason}")
        return self.__dict__["points"]

    def _columns(self, first, count=1):
        """Columns of the table of points, from the one of that name on; a copy that stays when the result is gone."""
        table = self._table()
        begin = table.columns.index(first)
        taken = table.rows[:, begin] if count == 1 else table.rows[:, begin:begin + count]
        made = numpy.ascontiguousarray(taken)
        made.setflags(write=False)
        return made

    def _measured(self, which):
        # The value has the name of its quantity; it stands behind the direction, before its interval.
        columns = self._table().columns
        return self._columns(columns[columns.index("nz") + 1 + which])

    @property
    def points(self):
        return self._columns("x_m", 3)

    @property
    def normals(self):
        return self._columns("nx", 3)

    @property
    def cells(self):
        made = self._columns("column", 2).astype(numpy.int64)
        made.setflags(write=False)
        return made

    @property
    def values(self):
        return self._measured(0)

    @property
    def low(self):
        return self._measured(1)

    @property
    def high(self):
        return self._measured(2)

    @property
    def direct_lx(self):
        return self._columns("direct_lx")

    @property
    def indirect_lx(self):
        return self._columns("indirect_lx")

    def image(self, values=None):
        values = self.values if values is None else numpy.asarray(values)
        cells = self.cells
        if values.shape != (len(cells),):
            raise ValueError(f"one value for each of the {len(cells)} points is needed, not {values.shape}")
        shape = (self.grid.rows, self.grid.columns)
        if 0 in shape:
            from . import Error
            raise Error(f"plane '{self.id}' is a list of points; it has no cells and so no image")
        image = numpy.full(shape, numpy.nan)
        image[cells[:, 1], cells[:, 0]] = values
        return image


# Names of the description for which people have another word.
_CLASS_NAMES = {"diagnostic": "Message", "where": "Place"}
_classes = {}


def class_name(name):
    """Of a part as the description names it: "Finding" of "finding", "FindingWaiver" of "finding_waiver"."""
    return _CLASS_NAMES.get(name) or "".join(word.capitalize() for word in name.split("_") if word)


def attribute_name(key):
    """A key that is a word of Python itself gets a '_': counts.pass_, finding.from_."""
    return key + "_" if keyword.iskeyword(key) else key


def make_part(name, words, fields):
    """Called by the compiled half for each part."""
    cls = _classes.get(name)
    if cls is None:
        title = name if name[:1].isupper() else class_name(name)
        base = globals().get(title, Part)
        # Classes differ by their names and words alone.
        cls = base if base is not Part else type(title, (Part,), {"__module__": "luxgate._parts"})
        if words:
            cls.__doc__ = words
        _classes[name] = cls
    part = object.__new__(cls)
    part.__dict__.update({attribute_name(key): value for key, value in fields.items()})
    return part
