"""Links lead somewhere, every block says what it is, and the documentation stays short."""

import re
import unittest

from pages import SOURCE, anchors, blocks, links, name_of, pages


class Pages(unittest.TestCase):
    def test_links_lead_to_files_and_headings(self):
        others = sorted((SOURCE / "robots").rglob("*.md"))
        others += [SOURCE / "benchmarks/results/results.md"]
        for page in [*pages(), *others]:
            for link in links(page):
                if re.match(r"[a-z]+:", link):
                    continue
                with self.subTest(page=name_of(page), link=link):
                    path, _, anchor = link.partition("#")
                    target = (page.parent / path).resolve() if path else page
                    self.assertTrue(target.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(target))

    def test_commands_are_in_blocks_that_are_run_or_say_why_not(self):
        for page in pages():
            for block in blocks(page):
                with self.subTest(page=name_of(page), line=block.line):
                    self.assertNotEqual(block.language, "", "a block says its language")
                    if re.search(r"(?m)^\$? ?\./run ", block.text):
                        self.assertEqual(block.language, "sh")

    def test_the_index_leads_to_every_page(self):
        index = SOURCE / "docs/README.md"
        reached = {(index.parent / link.partition("#")[0]).resolve() for link in links(index)}
        for page in pages():
            if page != index:
                self.assertIn(page.resolve(), reached)

    def test_sources_name_documents_that_exist(self):
        missing = []
        for folder in ("sim", "primitives", "planner", "benchmarks", "tests"):
            for file in (SOURCE / folder).rglob("*"):
                if file.suffix not in (".h", ".cpp", ".py", ".m", ".js", ".txt", ".cmake"):
                    continue
                if "node_modules" in file.parts:
                    continue
                for named in re.findall(r"docs/[\w./-]+\.(?:md|json)\b", file.read_text()):
                    if not (SOURCE / named).exists():
                        missing.append(f"{name_of(file)}: {named}")
        self.assertEqual(missing, [])

    def test_lengths(self):
        words = {page: len(page.read_text().split()) for page in pages()}
        self.assertLessEqual(words.pop(SOURCE / "README.md"), 900)
        self.assertLessEqual(words[SOURCE / "docs/architecture.md"], 1500)
        self.assertLessEqual(sum(words.values()), 35000)
        terms = re.findall(r"(?m)^\| (?!term )", (SOURCE / "docs/glossary.md").read_text())
        self.assertLessEqual(len(terms), 40)


if __name__ == "__main__":
    unittest.main()
