"""Checks the plot of a page that shows the fit of any point and channel, and the page on paper."""

import time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

FIT = '[data-plot="fit"]'

# The number of coloured pixels of each canvas that the selector finds. Curves are coloured; axes and background are grey or
# transparent.
COLOURED = """return [...document.querySelectorAll(arguments[0])].map((canvas) => {
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let coloured = 0;
  for (let i = 0; i < pixels.length; i += 4)
    if (pixels[i + 3] > 128 && Math.max(pixels[i], pixels[i + 1], pixels[i + 2]) - Math.min(pixels[i], pixels[i + 1], pixels[i + 2]) > 40) ++coloured;
  return coloured;
});"""


def said(driver):
    """The line of text above the plot: point, channel and FRAC."""
    return driver.find_element(By.CSS_SELECTOR, FIT + " .said").text


def chooser(driver, name):
    labels = driver.find_elements(By.CSS_SELECTOR, FIT + " label")
    return next(label.find_element(By.TAG_NAME, "select") for label in labels if label.text.startswith(name))


def check_fit(driver, path, check, load, survey):
    """Chooses point, view and range by the keyboard, and a point by a click."""
    load(driver, path)
    first = said(driver)
    check("FRAC " in first, f"{path.stem}: fit: {first}")
    worst = driver.execute_script("return Math.min(...data.fit.frfs.map((f) => f.frac))")
    check(f"FRAC {worst:.5f}" in first, f"{path.stem}: fit: the lowest FRAC, {worst:.5f}, comes first")
    # The measured curve equals the curve in the page's plot of FRFs, up to the quantisation steps of both.
    apart = driver.execute_script("""const fit = data.fit, worst = [];
      const lines = riceReader(fit.lines)(fit.count);
      for (const curve of data.frf.curves) {
        const levels = decoded(curve.db), at = (hz) => levels[Math.round((hz - data.frf.first_hz) / data.frf.df_hz)];
        worst.push(Math.min(...fit.frfs.map((f) => { const db = decodedFrf(fit, f).measured.db; return Math.max(...lines.map((k, i) => Math.abs(db[i] - at(fit.first_hz + k * fit.df_hz)))); })));
      }
      return Math.max(...worst);""")
    check(apart < 0.07, f"{path.stem}: fit: measured curves differ by {apart:.3f} dB from the FRFs")
    view = chooser(driver, "View")
    view.send_keys(Keys.END)
    time.sleep(0.1)
    check(driver.execute_script(COLOURED, FIT + " canvas.nyquist")[0] > 300, f"{path.stem}: fit: Nyquist by the keyboard")
    chooser(driver, "Range").send_keys(Keys.ARROW_DOWN)
    time.sleep(0.1)
    check(driver.execute_script(COLOURED, FIT + " canvas.nyquist")[0] > 300, f"{path.stem}: fit: Nyquist of one mode")
    view.send_keys(Keys.ARROW_UP)
    time.sleep(0.1)
    check(len(driver.find_elements(By.CSS_SELECTOR, FIT + " .uplot")) == 2, f"{path.stem}: fit: real and imaginary part")
    before = said(driver)
    buttons = {b.text: b for b in driver.find_elements(By.CSS_SELECTOR, FIT + " button")}
    buttons["Next"].send_keys(Keys.ENTER)
    time.sleep(0.1)
    check(said(driver) != before, f"{path.stem}: fit: the next FRF by the keyboard: {said(driver)}")
    reached = []
    driver.execute_script("document.body.focus(); window.scrollTo(0, 0)")
    for _ in range(60):
        ActionChains(driver).send_keys(Keys.TAB).perform()
        reached.append(driver.execute_script(f"""const e = document.activeElement; return e.closest('{FIT}') ? e.tagName + e.textContent.slice(0, 8) : ''"""))
    check(len({word for word in reached if word}) >= 4, f"{path.stem}: fit: reached by the Tab key")
    if not survey:
        return
    before = said(driver)
    geometry = driver.find_element(By.CSS_SELECTOR, FIT + " canvas.geometry")
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", geometry)
    for dx, dy in ((-120, 60), (120, -60)):
        ActionChains(driver).move_to_element_with_offset(geometry, dx, dy).click().perform()
        time.sleep(0.1)
        check(said(driver) != before, f"{path.stem}: fit: a click on the geometry chooses {said(driver).split(':')[0]}")
        before = said(driver)


def check_paper_of_fit(driver, path, check, load):
    """On paper the plots fill the width, and nothing is wider than the paper."""
    load(driver, path)
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print", "features": []})
    driver.execute_script("window.dispatchEvent(new Event('beforeprint'))")
    widths = driver.execute_script("return plots.map((d) => d.plot.width)")
    check(widths and set(widths) == {680}, f"{path.stem}: paper: plots of {set(widths)} px fill 180 mm")
    wide = driver.execute_script("document.body.style.width = '680px'; return [...document.querySelectorAll('main *')].filter((e) => e.scrollWidth > 682 && e.clientWidth > 0).map((e) => e.tagName + ' ' + e.scrollWidth).slice(0, 3)")
    check(not wide, f"{path.stem}: paper: nothing is wider than the paper {wide}")
    driver.execute_script("window.dispatchEvent(new Event('afterprint'))")
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "", "features": []})
