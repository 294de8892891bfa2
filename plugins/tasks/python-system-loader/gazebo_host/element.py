"""sdformat's Element."""

import xml.etree.ElementTree as ElementTree


class Param:
    """An attribute of an element."""

    def __init__(self, text):
        self._text = text

    def get_as_string(self, *config):
        return self._text


class Element(Missing):
    """sdformat's Element, for reading."""

    __module__ = "sdformat"

    def __init__(self, tree, parent=None):
        self._tree, self._parent = tree, parent

    def get_name(self):
        return self._tree.tag

    def get_parent(self):
        return self._parent

    def has_element(self, name):
        return self._tree.find(name) is not None

    def find_element(self, name):
        found = self._tree.find(name)
        return None if found is None else Element(found, self)

    def get_element(self, name):
        found = self.find_element(name)
        if found is None:
            raise RuntimeError(f"<{self.get_name()}> has no <{name}>")
        return found

    def get_first_element(self):
        return Element(self._tree[0], self) if len(self._tree) else None

    def get_next_element(self, name=""):
        if self._parent is None:
            return None
        siblings = list(self._parent._tree)
        for each in siblings[siblings.index(self._tree) + 1 :]:
            if name in ("", each.tag):
                return Element(each, self._parent)
        return None

    def has_attribute(self, name):
        return name in self._tree.attrib

    def get_attribute(self, name):
        return Param(self._tree.attrib[name]) if self.has_attribute(name) else None

    def get_attribute_count(self):
        return len(self._tree.attrib)

    def to_string(self, prefix="", *more):
        return prefix + ElementTree.tostring(self._tree, encoding="unicode")

    def _text(self, key):
        if not key:
            return self._tree.text or ""
        found = self._tree.find(key)
        return self._tree.attrib.get(key) if found is None else found.text or ""

    def _get(self, key, fallback, convert, default):
        """With a default, the value and whether it was given, as in sdformat."""
        text = self._text(key)
        value = (fallback[0] if fallback else default) if text is None else convert(text.strip())
        return (value, text is not None) if fallback else value

    def get_string(self, key="", *fallback):
        return self._get(key, fallback, str, "")

    def get_bool(self, key="", *fallback):
        return self._get(key, fallback, lambda text: text.lower() in ("1", "true"), False)

    def get_int(self, key="", *fallback):
        return self._get(key, fallback, int, 0)

    def get_double(self, key="", *fallback):
        return self._get(key, fallback, float, 0.0)

    def get_vector3d(self, key="", *fallback):
        return self._get(key, fallback, lambda text: Vector3d(*numbers(text.split())), Vector3d())

    def get_pose(self, key="", *fallback):
        return self._get(key, fallback, lambda text: Pose3d(*numbers(text.split())), Pose3d())

    get_float, get_unsigned_int, get_uint64 = get_double, get_int, get_int
