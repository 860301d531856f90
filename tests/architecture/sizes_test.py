#!/usr/bin/env python3
"""That the check of sizes counts what it says, and finds what is too large."""
import sys
import unittest

sys.dont_write_bytecode = True
import sizes  # noqa: E402  (after the line above, which keeps the sources clean)


def body(lines, indent="    "):
    return f"{indent}f();\n" * lines


class Functions(unittest.TestCase):
    def counted(self, text):
        return [(name, count) for name, _, count in sizes.functions(text)]

    def test_lines_between_the_braces_count(self):
        self.assertEqual(self.counted(f"int a(int x) {{\n{body(3)}}}\n"), [("a", 3)])
        self.assertEqual(self.counted("void b() {}\nvoid c() {\n}\nint d() { return 1; }\n"),
                         [("b", 0), ("c", 0), ("d", 0)])

    def test_functions_of_classes_and_namespaces_are_found(self):
        text = ("namespace kriva {\nnamespace {\nstruct A {\n    int x = 0;\n    void f() const {\n"
                f"{body(2)}    }}\n}};\nclass B final : public A {{\n  public:\n    B() : x_{{1}} {{\n{body(1)}    }}\n}};\n"
                f"}} // namespace\nvoid A::g() {{\n{body(4)}}}\n}} // namespace kriva\n")
        self.assertEqual([name for name, _ in self.counted(text)][0], "f")
        self.assertEqual(self.counted(text)[-1], ("A::g", 4))

    def test_what_stands_inside_belongs_to_the_function(self):
        text = ("void a() {\n    const auto b = [&](int x) {\n        return x;\n    };\n    if (b(1)) {\n        f();\n"
                "    }\n}\n")
        self.assertEqual(self.counted(text), [("a", 6)])

    def test_braces_in_comments_and_literals_are_none(self):
        self.assertEqual(self.counted('void a() {\n    f("}"); // }\n    g(\'{\'); /* } */\n}\n'), [("a", 2)])
        self.assertEqual(self.counted("#define X(a) { \\\n  a }\nvoid b() {\n    f();\n}\n"), [("b", 1)])

    def test_labels_of_a_switch_do_not_count(self):
        text = ("int a(E e) {\n    switch (e) {\n    case E::one:\n        return 1;\n    case E::two: // second\n"
                "        return 2;\n    default:\n        return 3;\n    }\n}\n")
        self.assertEqual(self.counted(text), [("a", 6)])

    def test_a_table_that_says_so_is_not_looked_at(self):
        text = f"// A table.\n// {sizes.EXEMPT}\nint a() {{\n{body(50)}}}\nint b() {{\n{body(50)}}}\n"
        self.assertEqual(self.counted(text), [("b", 50)])

    def test_algorithms_of_core_may_be_longer(self):
        for count, core, ui in ((40, 0, 0), (41, 0, 1), (60, 0, 1), (61, 1, 1)):
            text = f"void a() {{\n{body(count)}}}\n"
            self.assertEqual(len(sizes.faults({"core/a.cpp": text})), core, count)
            self.assertEqual(len(sizes.faults({"ui/a.cpp": text})), ui, count)

    def test_a_fault_names_place_and_size(self):
        text = f"int x;\n\nvoid A::b(int c) {{\n{body(41)}}}\n"
        self.assertEqual(sizes.faults({"ui/a.cpp": text}), ["ui/a.cpp:3: A::b has 41 lines, beyond 40"])


class Files(unittest.TestCase):
    def test_a_header_counts_with_its_source(self):
        self.assertEqual(sizes.faults({"ui/a.h": "\n" * 100, "ui/a.cpp": "\n" * 200, "ui/b.cpp": "\n" * 300}), [])
        self.assertEqual(sizes.faults({"ui/a.h": "\n" * 100, "ui/a.cpp": "\n" * 201}),
                         ["ui/a: 301 lines with its header, beyond 300"])

    def test_folders_count_their_own_headers(self):
        twelve = {f"ui/a/{i}.h": "" for i in range(12)}
        self.assertEqual(sizes.faults({**twelve, "ui/a/b/c.h": "", "ui/a/c.cpp": ""}), [])
        self.assertEqual(sizes.faults({**twelve, "ui/a/c.h": ""}), ["ui/a: 13 headers, beyond 12"])


if __name__ == "__main__":
    unittest.main()
