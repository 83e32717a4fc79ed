# SPDX-License-Identifier: GPL-3.0-or-later
"""The types of the package say what is in the module, name for name, and everything is explained."""
import ast
import inspect
import pathlib
import re
import unittest

import hitos

STUB = ast.parse(pathlib.Path(hitos.__file__).with_name("__init__.pyi").read_text())
# What every class of Python or of pybind11 has.
GIVEN = {"__init__", "__new__", "__repr__", "__str__", "__hash__", "__module__", "__doc__",
         "__dict__", "__weakref__",
         "__firstlineno__", "__static_attributes__"}  # since Python 3.13


def parameters_of_stub(function):
    """[(name, default as text or None, only by keyword)] without self."""
    arguments = function.args
    plain = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
    listed = [(a.arg, d, False) for a, d in zip(plain, defaults)]
    listed += [(a.arg, d, True) for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [(name, default and repr(ast.literal_eval(default)), keyword)
            for name, default, keyword in listed if name != "self"]


def parameters_of_module(function):
    """The same, of the signature that pybind11 writes before the words of a function."""
    signature = function.__doc__.splitlines()[0]
    inside = signature[signature.index("(") + 1:signature.rindex(")")]
    parts = re.split(r",\s+(?![^\[(]*[\])])", inside) if inside else []
    listed = []
    keyword = False
    for part in parts:
        if part == "*":
            keyword = True
            continue
        match = re.fullmatch(r"(\w+)(?:: (.*?))?(?: = (.*))?", part, re.DOTALL)
        listed.append((match[1], match[3] and repr(ast.literal_eval(match[3])), keyword))
    return [entry for entry in listed if entry[0] not in ("self", "arg0")]


def words_of(thing):
    """What is said of a thing beyond its signature."""
    text = inspect.getdoc(thing) or ""
    return re.sub(r"^\w+\(.*\) -> .*\n*", "", text).strip()


def own(cls):
    """The names that a class has of its own, methods and properties."""
    return {name: value for name, value in vars(cls).items()
            if name not in GIVEN and not name.startswith("__pybind11")
            and (not name.startswith("_") or re.fullmatch(r"__\w+__", name))}


CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in STUB.body if isinstance(node, ast.FunctionDef)}
VALUES = {node.target.id for node in STUB.body if isinstance(node, ast.AnnAssign)}


class Stubs(unittest.TestCase):
    def test_both_have_the_same_names(self):
        self.assertEqual(set(hitos.__all__) | {"__version__"},
                         set(CLASSES) | set(FUNCTIONS) | VALUES)
        public = {name for name in vars(hitos)
                  if not name.startswith("_") and name != "errors"}
        self.assertEqual(public, set(hitos.__all__))

    def test_functions_take_the_same_arguments(self):
        for name, node in FUNCTIONS.items():
            with self.subTest(name):
                self.assertEqual(parameters_of_module(getattr(hitos, name)),
                                 parameters_of_stub(node))

    def test_classes_have_the_same_members(self):
        for name, node in CLASSES.items():
            with self.subTest(name):
                said = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
                said |= {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
                self.assertEqual(set(own(getattr(hitos, name))), said - GIVEN)

    def test_methods_take_the_same_arguments_and_properties_are_some(self):
        for cls, node in CLASSES.items():
            for item in node.body:
                if not isinstance(item, ast.FunctionDef):
                    continue
                with self.subTest(f"{cls}.{item.name}"):
                    member = getattr(hitos, cls).__dict__[item.name]
                    named = {getattr(d, "id", "") for d in item.decorator_list}
                    self.assertEqual("property" in named, isinstance(member, property))
                    if isinstance(member, property):
                        self.assertIsNone(member.fset)
                    else:
                        self.assertEqual(parameters_of_module(member), parameters_of_stub(item))

    def test_classes_derive_from_the_same(self):
        for name, node in CLASSES.items():
            with self.subTest(name):
                said = [base.id for base in node.bases]
                real = [base.__name__ for base in getattr(hitos, name).__bases__]
                self.assertEqual(said or ["pybind11_object"], real)

    def test_everything_is_explained(self):
        self.assertIn("import hitos", hitos.__doc__)
        for name in hitos.__all__:
            thing = getattr(hitos, name)
            if isinstance(thing, int):
                continue
            with self.subTest(name):
                self.assertGreater(len(words_of(thing)), 20)
            if not inspect.isclass(thing) or issubclass(thing, Exception):
                continue
            for member, value in own(thing).items():
                with self.subTest(f"{name}.{member}"):
                    self.assertGreater(len(words_of(value)), 3)

    def test_nothing_of_cpp_shows(self):
        for name in hitos.__all__:
            thing = getattr(hitos, name)
            members = own(thing) if inspect.isclass(thing) else {}
            for shown, value in {name: thing, **members}.items():
                with self.subTest(f"{name}.{shown}"):
                    self.assertNotIn("::", value.__doc__ or "")

    def test_types_are_marked(self):
        self.assertTrue(pathlib.Path(hitos.__file__).with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main()
