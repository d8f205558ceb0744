#!/usr/bin/python3
"""Takes a picture of a page that `trunk report` made. It needs Debian's chromium, chromium-driver, python3-selenium and
python3-pil.

    build/trunk simulate scenarios/healthy.toml -o healthy.h5
    build/trunk simulate scenarios/hemiparalysis_right.toml -o paralysed.h5
    build/trunk report healthy.h5 paralysed.h5 -o two.html
    scripts/screenshot_report.py two.html -o reference/report.png --colour-by rise
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "cli"))
import browser  # noqa: E402  (its folder comes first)
from PIL import Image  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=pathlib.Path, help="report (HTML)")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="picture (PNG)")
    parser.add_argument("--width", type=int, default=1060, help="CSS pixels")
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--whole", action="store_true", help="the whole page and not only its beginning")
    parser.add_argument("--colour-by", choices=("anatomy", "distance", "rise", "side"),
                        help="[as the page opens]")
    arguments = parser.parse_args()
    if browser.MISSING:
        parser.error(f"no browser: {browser.MISSING}")
    window = browser.Browser(arguments.width, arguments.height, arguments.dark)
    try:
        window.open(arguments.page)
        window.run("""const select = document.querySelector('select[aria-label="colour by"]');
                      if (select && arguments[0]) { select.value = arguments[0]; select.dispatchEvent(new Event('change')); }""",
                   arguments.colour_by)
        window.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
        window.screenshot(arguments.output, arguments.whole)
        Image.open(arguments.output).quantize(256).save(arguments.output, optimize=True)  # a third of the size
    finally:
        window.close()


if __name__ == "__main__":
    main()
