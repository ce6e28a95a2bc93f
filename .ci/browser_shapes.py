"""Mode shapes as a user meets them: rotate, pan and zoom by mouse, touch and keys, choose modes, print.

`check(holds, what)` of browser.py prints each result and counts the failures.
"""

import time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

FIGURE = '[data-plot="shapes"]'
# A plate, a beam, a body and points scattered over a nearly flat surface: 24 points each, as the barrel has.
GEOMETRIES = {
    "plate": lambda i: (0.1 * (i % 6), 0.1 * (i // 6), 0),
    "beam": lambda i: (0, 0, 0.05 * i),
    "box": lambda i: (0.3 * (i // 8), 0.1 * (i % 8 // 4), 0.02 * (i % 4)),
    "leaf": lambda i: (0.2 * ((0.618 * i) % 1), 0.01 * i, 0.001 * (i % 3)),
}


def geometry(path, kind, points=24):
    rows = [f"{i},{x:.4f},{y:.4f},{z:.4f}" for i in range(points) for x, y, z in [GEOMETRIES[kind](i)]]
    path.write_text("point,x_m,y_m,z_m\n" + "\n".join(rows) + "\n")
    return str(path)


def canvases(driver):
    return [c for c in driver.find_elements(By.CSS_SELECTOR, f"{FIGURE} canvas") if c.is_displayed()]


def pictures(driver):
    return [driver.execute_script("return arguments[0].toDataURL()", canvas) for canvas in canvases(driver)]


def button(driver, text):
    return next(b for b in driver.find_elements(By.CSS_SELECTOR, f"{FIGURE} button") if b.text == text)


def fingers(driver, canvas, moves):
    """Touches the canvas with fingers at each of the moves: lists of (right, down) from its middle."""
    box = driver.execute_script("const r = arguments[0].getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]", canvas)
    for k, places in enumerate(moves):
        points = [{"x": box[0] + x, "y": box[1] + y, "id": i} for i, (x, y) in enumerate(places)]
        driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchStart" if k == 0 else "touchMove", "touchPoints": points})
    driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def check_still(driver, path, load, emulate, check):
    """With reduced motion the page shows the largest deflection, with signs, in colours that differ by sign."""
    emulate(driver, prefers_reduced_motion="reduce", prefers_color_scheme="light")
    load(driver, path)
    colours = driver.execute_script("""const c = document.querySelector('[data-plot="shapes"] canvas'), d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
      let [blue, orange] = [0, 0];
      for (let i = 0; i < d.length; i += 4) if (d[i + 3] > 200) { if (d[i + 2] - d[i] > 60) ++blue; if (d[i] - d[i + 2] > 60) ++orange; }
      return [blue, orange]""")
    check(min(colours) > 30, f"{path.stem}: both signs are coloured {colours}")


def check_pointer(driver, path, load, check):
    load(driver, path)
    canvas, before = canvases(driver)[0], pictures(driver)
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    ActionChains(driver).move_to_element(canvas).click_and_hold().move_by_offset(60, 20).release().perform()
    rotated = pictures(driver)
    check(all(a != b for a, b in zip(before, rotated)), f"{path.stem}: a drag rotates all drawings")
    ActionChains(driver).key_down(Keys.SHIFT).click_and_hold(canvas).move_by_offset(30, 0).release().key_up(Keys.SHIFT).perform()
    moved = pictures(driver)
    check(moved[0] != rotated[0], f"{path.stem}: a drag with shift moves")
    ActionChains(driver).scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -200).perform()
    time.sleep(0.1)
    zoomed = pictures(driver)
    check(zoomed[0] != moved[0], f"{path.stem}: the wheel zooms the focused drawing")
    fingers(driver, canvas, [[(-40, 0), (40, 0)], [(-60, 0), (60, 0)], [(-80, 10), (80, 10)]])
    time.sleep(0.1)
    check(pictures(driver)[0] != zoomed[0], f"{path.stem}: two fingers zoom")
    button(driver, "Reset view").click()
    check(pictures(driver) == before, f"{path.stem}: the view resets")


def check_keys(driver, path, load, check):
    """By the keyboard only: Tab reaches the drawings, keys change the view and pause."""
    load(driver, path)
    before = pictures(driver)
    for _ in range(200):
        ActionChains(driver).send_keys(Keys.TAB).perform()
        if driver.switch_to.active_element.tag_name == "canvas":
            break
    active = driver.switch_to.active_element
    check(active.tag_name == "canvas" and "Arrow keys" in (active.get_attribute("aria-label") or ""), f"{path.stem}: Tab reaches a drawing that says its keys")
    seen = [before[0]]
    for keys in ([Keys.ARROW_LEFT], [Keys.ARROW_UP], ["+"], ["-", "-"]):
        ActionChains(driver).send_keys(*keys).perform()
        seen.append(pictures(driver)[0])
    ActionChains(driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(Keys.SHIFT).perform()
    seen.append(pictures(driver)[0])
    check(len(set(seen)) == len(seen), f"{path.stem}: arrows, + and - change the view")
    ActionChains(driver).send_keys("0").perform()
    check(pictures(driver) == before, f"{path.stem}: 0 resets the view")
    ActionChains(driver).send_keys(" ").perform()
    moving = (pictures(driver)[0], time.sleep(0.3), pictures(driver)[0])
    ActionChains(driver).send_keys(" ").perform()
    still = (pictures(driver)[0], time.sleep(0.3), pictures(driver)[0])
    check(moving[0] != moving[2] and still[0] == still[2], f"{path.stem}: the space key plays and pauses")


def check_choice(driver, path, load, check):
    load(driver, path)
    all_shown = len(canvases(driver))
    boxes = driver.find_elements(By.CSS_SELECTOR, f"{FIGURE} .modes input")
    boxes[1].click()
    check(len(canvases(driver)) == all_shown - 1, f"{path.stem}: a mode can be left out")
    small = canvases(driver)[0].size["width"]
    button(driver, "Next alone").click()
    alone = canvases(driver)
    check(len(alone) == 1 and alone[0].size["width"] > 1.5 * small, f"{path.stem}: a mode alone is larger")
    first = pictures(driver)
    button(driver, "Next alone").click()
    check(len(canvases(driver)) == 1 and pictures(driver) != first, f"{path.stem}: the next mode alone")
    button(driver, "All").click()
    check(len(canvases(driver)) == len(boxes), f"{path.stem}: all modes")


def check_paper_of_shapes(driver, path, load, emulate, check):
    """While a mode moves on a dark screen, paper shows its largest deflection in the colours of paper."""
    emulate(driver, prefers_reduced_motion="reduce", prefers_color_scheme="light")
    load(driver, path)
    driver.execute_script("dispatchEvent(new Event('beforeprint'))")
    still = pictures(driver)
    driver.execute_script("dispatchEvent(new Event('afterprint'))")
    emulate(driver, prefers_reduced_motion="no-preference", prefers_color_scheme="dark")
    load(driver, path)
    driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvases(driver)[0])  # only visible ones move
    time.sleep(0.2)
    driver.execute_script("dispatchEvent(new Event('beforeprint'))")
    check(pictures(driver) == still, f"{path.stem}: paper shows the largest deflection")
    driver.execute_script("dispatchEvent(new Event('afterprint'))")
    after = (pictures(driver)[0], time.sleep(0.3), pictures(driver)[0])
    check(after[0] != after[2], f"{path.stem}: moves again after printing")
    emulate(driver, prefers_color_scheme="light")


def check_shapes(driver, path, load, emulate, check):
    check_still(driver, path, load, emulate, check)
    check_pointer(driver, path, load, check)
    check_keys(driver, path, load, check)
    check_choice(driver, path, load, check)
    check_paper_of_shapes(driver, path, load, emulate, check)
