#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The site as a reader meets it: every link and picture by its files, every page in a browser, wide and narrow."""

import functools
import http.server
import os
import sys
import threading
import unittest
import urllib.parse
from html.parser import HTMLParser

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

SITE = ""


class Page(HTMLParser):
    """The links, pictures and anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        with open(path, encoding="utf-8", errors="replace") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors.update(found[name] for name in ("id", "name") if found.get(name))
        if tag in ("a", "link", "img", "script"):
            self.links += [found[name] for name in ("href", "src") if found.get(name)]


def pages(api):
    """The pages below the site, by their relative path; those of the reference of classes where `api`."""
    for folder, _, names in os.walk(SITE):
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), SITE)
            if name.endswith(".html") and (path.startswith("api" + os.sep) == api):
                yield path


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class SiteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        handler = functools.partial(Quiet, directory=SITE)
        cls.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=cls.server.serve_forever, daemon=True).start()
        options = webdriver.ChromeOptions()
        for option in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        cls.browser.set_page_load_timeout(60)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.server.shutdown()

    def open(self, page):
        """Open a page; what the console says of it."""
        self.browser.set_window_size(1280, 900)
        self.browser.get_log("browser")
        self.browser.get(f"http://127.0.0.1:{self.server.server_port}/{page}")
        return [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]

    def test_links(self):
        """Every link of every page leads to a file that is there, and to an anchor in it."""
        parsed = functools.lru_cache(maxsize=None)(lambda path: Page(os.path.join(SITE, path)))
        self.maxDiff = None
        broken, count = [], 0
        for page in [*pages(False), *pages(True)]:
            for link in parsed(page).links:
                parts = urllib.parse.urlsplit(link)
                if parts.scheme or parts.netloc:
                    continue
                count += 1
                target = page
                if parts.path:
                    folder = "" if parts.path.startswith("/") else os.path.dirname(page)
                    target = os.path.normpath(os.path.join(folder, urllib.parse.unquote(parts.path).lstrip("/")))
                if os.path.isdir(os.path.join(SITE, target)):
                    target = os.path.join(target, "index.html")
                anchor = urllib.parse.unquote(parts.fragment)
                if not os.path.exists(os.path.join(SITE, target)):
                    broken.append(f"{page}: {link}: no such file")
                elif page.startswith("api/") and anchor == "nested-classes":
                    continue  # Doxygen names this part in its summary where all nested classes are private
                elif anchor and target.endswith(".html") and anchor not in parsed(target).anchors:
                    broken.append(f"{page}: {link}: no such anchor")
        self.assertGreater(count, 1000)
        self.assertEqual("\n".join(broken), "")

    def test_pages(self):
        """Pages, and one of those that show a source, open wide and narrow: no console error, every picture there, nothing cut off."""
        written = [page for page in pages(False) if not page.startswith("sources")]
        for page in [*written, "sources/Examples/Python/lights.py.html", "api/index.html"]:
            messages = self.open(page)
            for width in (1280, 390) if not page.startswith("api") else (1280,):
                with self.subTest(page=page, width=width):
                    self.browser.set_window_size(width, 900)
                    self.assertEqual(messages, [])
                    state = self.browser.execute_async_script("""
                        const done = arguments[0];
                        const images = [...document.images];
                        images.forEach(image => image.loading = "eager");
                        Promise.all(images.map(image => image.decode().catch(() => 0))).then(() => done({
                            missing: images.filter(image => !image.naturalWidth).map(image => image.src),
                            over: document.scrollingElement.scrollWidth - window.innerWidth}));""")
                    self.assertEqual(state["missing"], [])
                    self.assertLessEqual(state["over"], 0, "the page is wider than the window")

    def test_search(self):
        """The search finds a page by what it says."""
        self.open("index.html")
        self.browser.find_element(By.CSS_SELECTOR, ".md-search__input").send_keys("penumbra")
        found = WebDriverWait(self.browser, 20).until(
            lambda browser: browser.find_elements(By.CSS_SELECTOR, ".md-search-result__link"))
        self.assertGreater(len(found), 2)

    def test_dark(self):
        """The palette changes with a click and is kept on the next page."""
        def background():
            return self.browser.execute_script("return getComputedStyle(document.body).backgroundColor")

        self.open("index.html")
        before = background()
        self.browser.find_element(By.CSS_SELECTOR, "label[title]:not([hidden])[for^=__palette]").click()
        WebDriverWait(self.browser, 10).until(lambda _: background() != before)
        after = background()
        self.open("contents.html")
        self.assertEqual(background(), after)

    def test_gallery(self):
        """From a picture of the gallery a click leads to the script that made it."""
        self.open("2-gallery.html")
        self.browser.find_element(By.LINK_TEXT, "lights.py").send_keys(Keys.ENTER)
        WebDriverWait(self.browser, 10).until(lambda browser: "lights" in browser.current_url)
        self.assertIn("vtkAreaLightSource", self.browser.find_element(By.TAG_NAME, "article").text)


if __name__ == "__main__":
    SITE = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
