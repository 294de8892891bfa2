"""The bill of materials that the build made: CycloneDX 1.5, with each package that debian/control and the page name."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TOOL = PROJECT / "tools/sbom"


def build_dependencies():
    listed = re.search(r"^Build-Depends:\n((?: .*\n)+)", (PROJECT / "debian/control").read_text(), re.M)[1]
    return re.findall(r"^ ([a-z0-9.+-]+)", listed, re.M)


class Sbom(unittest.TestCase):
    def setUp(self):
        self.text = pathlib.Path(os.environ["PONGSIM_SBOM"]).read_text()
        self.bom = json.loads(self.text)
        self.components = {each["bom-ref"]: each for each in self.bom["components"]}

    def test_its_structure_is_that_of_cyclonedx(self):
        self.assertEqual((self.bom["bomFormat"], self.bom["specVersion"], self.bom["version"]), ("CycloneDX", "1.5", 1))
        self.assertEqual(len(self.components), len(self.bom["components"]), "each has a reference of its own")
        for each in self.bom["components"]:
            self.assertIn(each["scope"], ("required", "excluded"))
            self.assertEqual(each["type"], "library")
            for licence in each["licenses"]:
                self.assertTrue(licence.get("expression") or licence["license"].get("id") or licence["license"].get("name"))
            for hash_ in each.get("hashes", []):
                self.assertRegex(hash_["content"], "^[0-9a-f]{128}$")
                self.assertEqual(hash_["alg"], "SHA-512")
        depending, = self.bom["dependencies"]
        self.assertEqual(depending["ref"], self.bom["metadata"]["component"]["bom-ref"])
        self.assertEqual(set(depending["dependsOn"]), set(self.components))

    def test_it_has_what_debian_builds_with(self):
        names = build_dependencies()
        self.assertGreater(len(names), 30)
        for name in names:
            each = self.components[f"deb:{name}"]
            self.assertTrue(each["licenses"], name)
            if each["scope"] == "required" and shutil.which("dpkg-query"):
                shown = subprocess.run(["dpkg-query", "-W", "-f", "${Version}\n", name], capture_output=True, text=True)
                self.assertEqual(each["version"], shown.stdout.split("\n")[0], name)

    def test_it_has_what_debian_installs_with_it(self):
        for name in ("libembree3-3", "libosmesa6", "ca-certificates", "python3-lxml"):
            self.assertIn(f"deb:{name}", self.components)

    def test_it_has_the_packages_in_the_page(self):
        page = PROJECT / "components/web/page"
        lock = json.loads((page / "package-lock.json").read_text())["packages"]
        for name, version in json.loads((page / "package.json").read_text())["dependencies"].items():
            each = self.components[f"npm:{name}"]
            self.assertEqual(each["version"], version)
            self.assertEqual(each["licenses"], [{"expression": lock[f"node_modules/{name}"]["license"]}])
        self.assertNotIn("npm:typescript", self.components)

    def test_it_is_that_of_these_sources(self):
        self.assertEqual(subprocess.run([TOOL], capture_output=True, text=True, check=True).stdout, self.text)

    def test_a_package_without_a_licence_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for file in ("tools/sbom", "debian/control", "docs/dependencies.md", "CMakeLists.txt",
                         "components/web/page/package-lock.json"):
                (copy / file).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(PROJECT / file, copy / file)
            control = copy / "debian/control"
            control.write_text(control.read_text().replace(" zlib1g-dev,\n", " zlib1g-dev,\n libnobody-dev,\n"))
            made = subprocess.run([copy / "tools/sbom"], capture_output=True, text=True)
            self.assertEqual(made.returncode, 1)
            self.assertIn("docs/dependencies.md has no licence of libnobody-dev", made.stderr)


if __name__ == "__main__":
    unittest.main()
