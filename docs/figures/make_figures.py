#!/usr/bin/env python3
"""Draws the figures of docs/frames.md into this folder: python3 docs/figures/make_figures.py

Standard library only, and deterministic: running it twice gives the same bytes.
Every number printed in a figure is computed here from the geometry that is drawn.
"""

import math
from pathlib import Path

from drawing import (AXES, FAINT, FORCE, INK, MOTION, MUTED, ORIGIN, PANEL, UPRIGHT, WRONG, X, Y, Z, Camera, Page, add,
                     along, arrow, board, cross, disc, panel, scale, side_view, sub, tool, triad, turn, turned)

MINUS = "\u2212"
RED, _, BLUE = AXES
RATE = "#9A6700"  # the colour of motions, dark enough for words


def signed(value, digits=0):
    text = f"{abs(value):.{digits}f}"
    return text if value >= 0 or float(text) == 0 else MINUS + text


def row(vector):
    return ", ".join(f"{c + 0.0:g}".replace("-", MINUS) for c in vector)


# ---- 1. the four references -----------------------------------------------------------

TILTED = UPRIGHT.then(Z, 8).then(X, 32).then(Y, -8)
LEANING = UPRIGHT.then(Z, 55).then(Y, 34).then(X, 4)
POINT = (0.52, 0.22, 0.23)


def magnifier(page, at, rotation, name, lines):
    """The tip, enlarged, with one triad; everything else pale."""
    radius, clip = 84, f"clip{len(page.defs)}"
    page.circle(at, radius, "white")
    page.defs.append(f'<clipPath id="{clip}"><circle cx="{at[0]}" cy="{at[1]}" r="{radius}"/></clipPath>')
    camera = Camera((at[0] - 6, at[1] + 22), 560)
    page.put(f'<g clip-path="url(#{clip})">')
    board(page, camera, ORIGIN, TILTED, (0.5, 0.3), opacity=0.6)
    tool(page, camera, ORIGIN, LEANING, 0.9, opacity=0.4)
    page.put("</g>")
    page.circle(at, radius, "none", FAINT)
    triad(page, camera, ORIGIN, rotation, 0.105, halo="white", width=4)
    page.text((at[0] + radius + 18, at[1] - 36), name, 19, INK, bold=True)
    page.lines((at[0] + radius + 18, at[1] - 8), lines, 15, MUTED)


def overview():
    page = Page("references", 980, 600, "A tool on a tilted board, and the four references of its contact")
    camera = Camera((76, 430), 620)
    tip, places = camera(POINT), [(700, 110 + 190 * k) for k in range(3)]
    board(page, camera, POINT, TILTED, (0.27, 0.22))
    for place in places:
        page.polyline([tip, place], FAINT, 1.6)
    page.polyline([camera(ORIGIN), tip], MUTED, 1.8, "2 5")
    page.text(add(camera(scale(0.36, POINT)), (-4, -20)), "p", 19, MUTED, "middle", bold=True)
    triad(page, camera, ORIGIN, UPRIGHT, 0.16, halo="white", width=4)
    page.text((40, 490), "World", 19, INK, bold=True)
    page.text((40, 516), "world axes, at the world\u2019s origin", 15, MUTED)
    tool(page, camera, POINT, LEANING, 1.15)
    corner = add(POINT, TILTED((-0.16, -0.185, 0.0)))
    triad(page, camera, corner, TILTED, 0.075, width=2.6, size=14, halo="white")
    page.text(add(camera(corner), (-14, 6)), "C1", 16, INK, "end", bold=True)
    top = camera(along(POINT, 0.36, LEANING(Z)))
    page.text(add(top, (-66, -44)), "tool B2, with frame C2 at its tip", 16, INK, "middle", bold=True)
    edge = camera(add(POINT, TILTED((0.0, -0.22, 0.0))))
    page.text(add(edge, (14, 36)), "board B1, with frame C1", 16, INK, "middle", bold=True)
    page.circle(tip, 10, "none", INK, 2)
    magnifier(page, places[0], LEANING, "Local", ["the tool\u2019s axes,", "at the tip"])
    magnifier(page, places[1], UPRIGHT, "Centered", ["world axes,", "at the tip"])
    magnifier(page, places[2], TILTED, "Surface", ["axes you fix in C1,", "at the tip"])
    return page


# ---- 2. Local -------------------------------------------------------------------------

def table(page, camera, half=0.32, centre=ORIGIN, rotation=UPRIGHT, thick=0.035):
    board(page, camera, centre, rotation, (half, 0.1), thick)


def local():
    page = Page("local", 980, 450, "Local: the normal turns with the wrist")
    lean, force = 20.0, 30.0
    for x, angle, heading in ((20, 0.0, "Wrist upright"), (500, lean, f"Wrist turned by {lean:.0f}\u00b0")):
        panel(page, x, 20, 460, 410, heading)
        camera = side_view((x + 215, 300), 570)
        rotation = UPRIGHT.then(Y, angle)
        table(page, camera)
        tool(page, camera, ORIGIN, rotation, 1.0, opacity=0.75)
        slide = scale(0.28 if angle else 0.30, rotation(X))
        page.polyline([camera(scale(-1, slide)), camera(slide)], MOTION, 2.5, WRONG if angle else "")
        triad(page, camera, ORIGIN, rotation, (0.17, 0.1, 0.37), size=17)
        push = scale(0.21, rotation(Z))
        arrow(page, camera, ORIGIN, push, FORCE, f"\u03bb_z = {force:.0f} N", 5, size=17, aside=(62, 12))
        if angle:
            side, normal = (0.21 * math.sin(math.radians(angle)), 0, 0), (0, 0, push[2])
            arrow(page, camera, ORIGIN, normal, FORCE, "", 2.5, WRONG)
            page.text(add(camera(scale(0.62, normal)), (-12, 0)), f"{force * normal[2] / 0.21:.1f} N", 15, FORCE,
                      "end", bold=True, halo="none")
            page.polyline([camera(normal), camera(push)], FORCE, 2, WRONG)
            page.text(add(camera(normal), (-6, -18)), f"{force * side[0] / 0.21:.1f} N sideways", 15, FORCE, "end",
                      bold=True, halo="none")
        notes = ["\u03bb_z pushes along the table\u2019s normal, and the", "tip slides on the table"]
        if angle:
            notes = ["\u03bb_z pushes sideways too, and the line on which", "the tip may slide leaves the table"]
        page.lines((x + 230, 386), notes, 15, MUTED, "middle", halo=PANEL)
    return page


# ---- 3. Centered ----------------------------------------------------------------------

def centered():
    page = Page("centered", 980, 450, "Centered: axes that do not turn, seen from a tool that does")
    step, before = 34.0, UPRIGHT
    after = UPRIGHT.then(Y, step)
    panel(page, 20, 20, 460, 410, "Seen from the room")
    camera = side_view((215, 320), 600)
    table(page, camera, 0.3)
    tool(page, camera, ORIGIN, after, 0.95, opacity=0.9)
    tool(page, camera, ORIGIN, before, 0.95, opacity=0.35)
    triad(page, camera, ORIGIN, UPRIGHT, (0.18, 0.1, 0.36), size=17)
    arrow(page, camera, ORIGIN, scale(0.24, Z), FORCE, "f", 5, size=19, aside=(-20, 22))
    turn(page, camera, ORIGIN, Y, 0.325, (0.04, 0, 1), step - 5, MOTION)
    page.text(camera((0.13, 0, 0.345)), "w dq", 17, RATE, "start", bold=True, halo=PANEL)
    page.text((250, 395), "The wrist turns. The numbers in f stay.", 15, MUTED, "middle", halo=PANEL)

    panel(page, 500, 20, 460, 410, "Seen from the tool")
    camera = side_view((730, 320), 600)
    tool(page, camera, ORIGIN, UPRIGHT, 0.95, opacity=0.6)
    triad(page, camera, ORIGIN, UPRIGHT, (0.18, 0.1, 0.36), size=17)
    old = scale(0.24, Z)
    new = turned(old, Y, -math.radians(step))
    arrow(page, camera, ORIGIN, old, FORCE, "f_L(q)", 5, size=17, aside=(58, 22))
    arrow(page, camera, ORIGIN, new, FORCE, "f_L(q + dq)", 5, size=17, aside=(-46, 8))
    arrow(page, camera, old, sub(new, old), INK, "", 3)
    page.text(add(camera(scale(0.5, add(old, new))), (-26, -24)), "f_L \u00d7 w_L dq", 17, INK, "end", bold=True,
              halo=PANEL)
    page.text((730, 395), "The same force turns. The black arrow is the skew term.", 15, MUTED, "middle", halo=PANEL)
    return page


# ---- 4. Surface -----------------------------------------------------------------------

def surface():
    page = Page("surface", 980, 400, "Surface: the axes belong to the board")
    panel(page, 20, 20, 590, 360, "B1 is the world: one task, any board")
    for x, y, angle in ((120, 245, 0.0), (320, 255, -35.0), (545, 195, -90.0)):
        camera, rotation = side_view((x, y), 500), UPRIGHT.then(Y, angle)
        table(page, camera, 0.17, rotation=rotation)
        tool(page, camera, ORIGIN, rotation.then(Y, 14), 0.62, opacity=0.75)
        triad(page, camera, ORIGIN, rotation, (0.12, 0.1, 0.24), size=17)
    page.text((315, 352), "Only the rotation R changes. \u03bb_z is the push on the board each time.", 15, MUTED,
              "middle", halo=PANEL)
    panel(page, 630, 20, 330, 360, "B1 moves: so do the axes")
    camera = side_view((725, 288), 560)
    for angle, opacity in ((0.0, 0.45), (-30.0, 1.0)):
        rotation = UPRIGHT.then(Y, angle)
        at = rotation((0.14, 0, 0.0))
        table(page, camera, 0.16, rotation((0.10, 0, 0)), rotation)
        page.put(f'<g opacity="{opacity}">')
        triad(page, camera, at, rotation, (0.12, 0.1, 0.17), size=17)
        page.put("</g>")
    turn(page, camera, ORIGIN, Y, 0.33, X, -26, MOTION)
    page.text(camera((0.345, 0, 0.10)), "w_1", 17, RATE, "start", bold=True, halo=PANEL)
    page.text((795, 352), "R is fixed in C1, not in the world.", 15, MUTED, "middle", halo=PANEL)
    return page


# ---- 4b. curved surfaces --------------------------------------------------------------

def arc(centre, radius, begin, end, steps=60):
    """In the plane y = 0, degrees from z towards x."""
    angles = [math.radians(begin + (end - begin) * k / steps) for k in range(steps + 1)]
    return [add(centre, (radius * math.sin(a), 0.0, radius * math.cos(a))) for a in angles]


def curved():
    page = Page("curved", 980, 430, "Curved surfaces: the axes follow the normal")
    ball, tip, lean = 0.42, 0.05, 38.0
    panel(page, 20, 20, 460, 390, "Known: the tip\u2019s centre on a ball")
    camera, centre = side_view((195, 470), 600), ORIGIN
    page.polyline([camera(q) for q in arc(centre, ball, -24, 62)], INK, 3)
    page.polyline([camera(q) for q in arc(centre, ball + tip, -24, 62)], MUTED, 1.8, "2 5")
    for angle, opacity in ((0.0, 0.4), (lean, 1.0)):
        rotation = UPRIGHT.then(Y, angle)
        at = scale(ball + tip, rotation(Z))
        page.put(f'<g opacity="{opacity}">')
        page.circle(camera(at), tip * 600, "none", INK, 2)
        triad(page, camera, at, rotation, (0.12, 0.1, 0.15), size=17)
        page.put("</g>")
    at = scale(ball + tip, UPRIGHT.then(Y, lean)(Z))
    arrow(page, camera, at, scale(0.1, UPRIGHT.then(Y, lean)(Z)), FORCE, "\u03bb_z", 6, size=17, aside=(26, 26))
    page.text(camera((-0.03, 0, ball + tip + 0.19)), "near", 16, MUTED, "end", bold=True, halo=PANEL)
    page.text((250, 386), f"Turned with the normal by {lean:.0f}\u00b0. On the way the bend", 15, MUTED,
              "middle", halo=PANEL)
    page.text((250, 404), "is in the acceleration that is held.", 15, MUTED, "middle", halo=PANEL)

    tilt, bend = 24.0, 1.0  # degrees, 1/m
    panel(page, 500, 20, 460, 390, "Unknown: what the tip\u2019s own path says")
    camera = side_view((590, 290), 620)

    def height(x):
        return math.tan(math.radians(tilt)) * x - 0.5 * bend * x * x

    page.polyline([camera((x / 50, 0, 0)) for x in range(-4, 28)], FAINT, 2.4, WRONG)
    page.text(camera((0.42, 0, -0.035)), "believed", 15, MUTED, "middle", halo=PANEL)
    page.polyline([camera((x / 50, 0, height(x / 50))) for x in range(-4, 28)], INK, 3)
    for k in range(12):
        page.circle(camera((0.025 * k, 0, height(0.025 * k) + 0.004)), 3.4, MOTION)
    x = 0.275
    slope = math.degrees(math.atan(math.tan(math.radians(tilt)) - bend * x))
    at = (x, 0, height(x))
    triad(page, camera, at, UPRIGHT.then(Y, -slope), (0.13, 0.1, 0.17), size=17)
    triad(page, camera, ORIGIN, UPRIGHT, (0.09, 0.1, 0.16), width=2.6, size=14)
    ahead = [(q / 50, 0, height(q / 50)) for q in range(14, 28)]
    page.polyline([camera(add(q, (0, 0, 0.012))) for q in ahead], MOTION, 2, "2 5")
    page.text(camera((0.45, 0, height(0.45) + 0.06)), "ahead", 15, RATE, "middle", halo=PANEL)
    page.text((730, 386), "Slope and bend of where it has been: the plan holds", 15, MUTED, "middle",
              halo=PANEL)
    page.text((730, 404), "the force along them, and along what follows ahead.", 15, MUTED, "middle", halo=PANEL)
    return page


# ---- 5. World -------------------------------------------------------------------------

def world():
    page = Page("world", 980, 500, "World: a pure push at the tool has a moment about the origin")
    p, f, w, u = (0.6, 0.0, 0.4), (0.0, 0.0, 30.0), (0.0, 0.5, 0.0), ORIGIN
    moment, at_origin = cross(p, f), add(u, cross(p, w))
    for x, heading, m, v in ((20, "World", moment, at_origin), (500, "Centered", ORIGIN, u)):
        panel(page, x, 20, 460, 460, heading)
        camera = side_view((x + 85, 362), 440)
        table(page, camera, 0.21, p)
        tool(page, camera, p, UPRIGHT, 0.6, opacity=0.75)
        here = ORIGIN if heading == "World" else p
        page.polyline([camera(ORIGIN), camera(p)], MUTED, 1.8, "2 5")
        if heading == "World":
            page.polyline([camera((0, 0, 0)), camera((0.6, 0, 0))], FAINT, 1.5)
            page.polyline([camera((0.6, 0, -0.02)), camera((0.6, 0, 0.36))], FAINT, 1.5)
            page.text(camera((0.36, 0, -0.04)), f"lever {p[0]} m", 15, MUTED, "middle", halo=PANEL)
            turn(page, camera, ORIGIN, Y, 0.20, (0.92, 0, 0.4), -110, FORCE, 4)
            page.text(camera((-0.02, 0, 0.255)), f"{signed(moment[1])} N m", 17, FORCE, "middle", bold=True,
                      halo=PANEL)
        else:
            page.circle(camera(ORIGIN), 5, FAINT)
            page.text(add(camera(ORIGIN), (0, 20)), "origin", 15, MUTED, "middle", halo=PANEL)
        triad(page, camera, here, UPRIGHT, (0.13, 0.1, 0.13 if heading == "World" else 0.22), size=17)
        arrow(page, camera, p, (0, 0, 0.15), FORCE, "30 N", 5, size=17, aside=(48, 14))
        turn(page, camera, p, Y, 0.215, (-0.75, 0, 0.66), 42, MOTION)
        page.text(camera(add(p, (-0.18, 0, 0.15))), f"{w[1]} rad/s", 16, RATE, "end", bold=True, halo=PANEL)
        page.text((x + 34, 424), f"\u03bb = ({row(f)} | {row(m)}) N, N m", 17, FORCE, bold=True, halo=PANEL)
        page.text((x + 34, 454), f"\u03bd = ({row(v)} | {row(w)}) m/s, rad/s", 17, RATE, bold=True,
                  halo=PANEL)
    return page


# ---- 6. two moving bodies ---------------------------------------------------------------

def velocities(page):
    panel(page, 20, 20, 500, 420, "Motion: u = v_2(p) \u2212 v_1(p)")
    camera, p, spin = Camera((265, 245), 540, azimuth=-75, elevation=38.0), (-0.02, -0.10, 0.0), (0, 0, 2.0)
    disc(page, camera, ORIGIN, UPRIGHT, 0.40)
    base = (-0.24, -0.03, 0.0)
    triad(page, camera, base, UPRIGHT, 0.085, width=2.6, size=14, halo="none")
    page.text(add(camera(base), (-12, 12)), "C1", 16, INK, "end", bold=True, halo="none")
    turn(page, camera, ORIGIN, Z, 0.34, (1, 0.15, 0), 62, MOTION, 3.5)
    page.text(camera((0.20, 0.20, 0)), "w_1", 18, RATE, "middle", bold=True, halo="none")
    tool(page, camera, p, UPRIGHT.then(X, -12), 0.85, opacity=0.8)
    v1 = cross(spin, p)
    v2 = (-0.06, -0.16, 0.0)
    arrow(page, camera, p, v1, INK, "v_1(p)", 3.5, size=17, aside=(22, 2), halo="none")
    arrow(page, camera, p, v2, MUTED, "v_2(p)", 3.5, size=17, aside=(-34, -10), halo="none")
    arrow(page, camera, add(p, v1), sub(v2, v1), MOTION, "", 4.5)
    page.text(add(camera(add(p, scale(0.5, add(v1, v2)))), (10, 14)), "u", 20, RATE, bold=True, halo="none")
    page.circle(camera(p), 5, INK)
    page.text(add(camera(p), (-12, 4)), "p", 18, INK, "end", bold=True, halo="none")
    page.text((270, 421), "v_1(p): the point of B1 that is now under the tool", 15, MUTED, "middle", halo=PANEL)


def action_and_reaction(page):
    panel(page, 540, 20, 420, 420, "Force: what B1 exerts on B2")
    camera, gap = side_view((740, 265), 520), (0, 0, 0.05)
    table(page, camera, 0.28)
    tool(page, camera, gap, UPRIGHT, 0.85, opacity=0.75)
    arrow(page, camera, gap, scale(0.16, Z), FORCE, "\u03bb on B2", 5, size=17, aside=(70, 22))
    arrow(page, camera, ORIGIN, scale(-0.16, Z), FORCE, "\u2212\u03bb on B1", 5, size=17, aside=(74, -18))
    page.text(camera((-0.26, 0, -0.065)), "B1", 17, INK, bold=True, halo=PANEL)
    page.text(camera((-0.12, 0, 0.22)), "B2", 17, INK, bold=True, halo=PANEL)
    page.text((750, 421), "One \u03bb, both at p, opposite signs", 15, MUTED, "middle", halo=PANEL)


def two_bodies():
    page = Page("two_bodies", 980, 460, "A contact between two moving bodies")
    velocities(page)
    action_and_reaction(page)
    return page


# ---- 7. directions --------------------------------------------------------------------

NAMES = ("v_x", "v_y", "v_z", "w_x", "w_y", "w_z")


def held_axes(page, camera, held):
    """Straight arrows for translations, arcs for rotations: colour if held, pale if free."""
    for i, axis in enumerate((X, Y, Z)):
        arrow(page, camera, ORIGIN, scale(0.21, axis), AXES[i] if i in held else FAINT, "", 4.5 if i in held else 2)
    for i, (axis, start) in enumerate(((X, (0, -1, 0.25)), (Y, (0.9, 0, 0.5)), (Z, (0.2, -1, 0)))):
        on = i + 3 in held
        turn(page, camera, scale(0.125, axis), axis, 0.042, start, 285, AXES[i] if on else FAINT, 3.4 if on else 1.8)


def directions():
    page = Page("directions", 980, 350, "Directions: what a contact holds, and what it leaves free")
    cases = (("z()", "a tip on a plane", (2,)), ("linear()", "a point that sticks", (0, 1, 2)),
             ("pad_z()", "a flat pad on a plane", (2, 3, 4)), ("all()", "a glued hand or foot", range(6)))
    for k, (heading, use, held) in enumerate(cases):
        x = 20 + 238 * k
        panel(page, x, 20, 226, 310, heading)
        page.text((x + 113, 70), use, 15, MUTED, "middle", halo=PANEL)
        camera = Camera((x + 104, 200), 430, azimuth=-65, elevation=26)
        board(page, camera, ORIGIN, UPRIGHT, (0.17, 0.17), 0.02)
        held_axes(page, camera, held)
        for i, name in enumerate(NAMES):
            colour = AXES[i % 3] if i in held else "white"
            at = (x + 14 + 34 * i, 286)
            page.box(*at, 29, 29, colour, FAINT if i not in held else colour, 6)
            page.text((at[0] + 14.5, at[1] + 13), name, 14, "white" if i in held else MUTED, "middle", bold=True,
                      halo="none")
    return page


# ---- 8. the drift ----------------------------------------------------------------------

SLIDE, TILT_RATE, SECONDS = 0.07, 0.2, 1.0  # m/s, rad/s, s


def height_of_the_tool(tilt_rate, spatial, steps=1000):
    """Heights over time under alpha_z = 0, by the midpoint rule; u is the tool's velocity in Centered axes."""
    w, u, z, dt = (0.0, tilt_rate, 0.0), (SLIDE, 0.0, 0.0), 0.0, SECONDS / steps
    heights = [z]
    for _ in range(steps):
        # Spatial: alpha = du/dt - w x u = 0 along z. TimeDerivative: alpha = du/dt = 0 along z.
        du = (0.0, 0.0, cross(w, u)[2] if spatial else 0.0)
        middle = along(u, 0.5 * dt, du)
        z, u = z + dt * middle[2], along(u, dt, du)
        heights.append(z)
    return heights


def plot_axes(page, x, y, width, height, low, high, step):
    """A frame with ticks; returns the map from (s, mm) to pixels."""
    def place(t, mm):
        return (x + width * t / SECONDS, y + height * (high - mm) / (high - low))
    for k in range(6):
        t = SECONDS * k / 5
        page.polyline([place(t, low), place(t, high)], "#E4E8EC", 1)
        page.text(add(place(t, low), (0, 18)), f"{t:.1f}", 14, MUTED, "middle")
    for mm in range(low, high + 1, step):
        page.polyline([place(0, mm), place(SECONDS, mm)], "#E4E8EC" if mm else MUTED, 1 if mm else 1.4)
        page.text(add(place(0, mm), (-10, 0)), signed(mm), 14, MUTED, "end")
    page.text((x + width / 2, y + height + 46), "time (s)", 15, INK, "middle")
    page.text((x - 34, y - 22), "height of the tool over the plane (mm)", 15, INK)
    return place


def sliding_pad(page):
    panel(page, 20, 20, 330, 400, "The motion")
    camera = side_view((105, 275), 430)
    table(page, camera, 0.36, (0.18, 0, 0))
    for at, angle, opacity in ((0.0, 0.0, 0.35), (0.24, 20.0, 0.95)):
        tool(page, camera, (at, 0, 0), UPRIGHT.then(Y, angle), 0.72, opacity=opacity)
    arrow(page, camera, (0.05, 0, -0.075), (0.2, 0, 0), MOTION, "", 4)
    page.text(camera((0.15, 0, -0.125)), f"slides: v_x = {SLIDE} m/s", 16, RATE, "middle", bold=True, halo=PANEL)
    turn(page, camera, (0.24, 0, 0), Y, 0.27, (-0.05, 0, 1), 38, MOTION, 4)
    page.text((185, 112), f"turns: w_y = {TILT_RATE} rad/s", 16, RATE, "middle", bold=True, halo=PANEL)
    page.text((185, 388), f"(w \u00d7 v)_z = {signed(cross((0, TILT_RATE, 0), (SLIDE, 0, 0))[2], 3)} m/s\u00b2", 16,
              INK, "middle", halo=PANEL)


def drift():
    page = Page("drift", 980, 440, "Held at zero spatial acceleration, a sliding, turning tool drifts off the plane")
    sliding_pad(page)
    place = plot_axes(page, 430, 70, 340, 290, -8, 8, 4)
    curves = ((-TILT_RATE, True, RED, WRONG, ["Spatial", "turning backward:", "{:+.1f} mm, lifts off"]),
              (TILT_RATE, False, BLUE, "", ["TimeDerivative", "either way:", "{:.1f} mm, stays"]),
              (TILT_RATE, True, RED, WRONG, ["Spatial", "turning forward:", "{:.1f} mm, sinks in"]))
    for rate, spatial, colour, dash, words in curves:
        heights = [1000 * z for z in height_of_the_tool(rate, spatial)]
        points = [place(SECONDS * k / (len(heights) - 1), h) for k, h in enumerate(heights)]
        page.polyline(points[::20], colour, 4, "9 7" if dash else "")
        words = [w.format(heights[-1]).replace("-", MINUS) for w in words]
        at = add(points[-1], (14, -20 if abs(heights[-1]) < 1 else (-14 if heights[-1] > 0 else -26)))
        page.text(at, words[0], 16, colour, bold=True)
        page.lines(add(at, (0, 21)), words[1:], 15, MUTED)
    return page


# ---- 9. signs -------------------------------------------------------------------------

def signs():
    page = Page("signs", 980, 330, "Signs: the force of a contact is what the environment exerts on the robot")
    cases = (("A table", 0.0, "\u03bb_z > 0", (16, 10)), ("A ceiling", 180.0, "\u03bb_z < 0", (16, -10)))
    for k, (heading, angle, words, aside) in enumerate(cases):
        x = 20 + 320 * k
        panel(page, x, 20, 300, 290, heading)
        camera = side_view((x + 150, 235 if not angle else 110), 430)
        rotation = UPRIGHT.then(Y, angle)
        table(page, camera, 0.28, rotation=rotation)
        tool(page, camera, ORIGIN, rotation, 0.9, opacity=0.75)
        arrow(page, camera, ORIGIN, scale(0.2, rotation(Z)), FORCE, "", 5)
        page.text(add(camera(scale(0.2, rotation(Z))), (34, 6)), words, 19, FORCE, bold=True, halo=PANEL)
        triad(page, side_view((x + 46, 258 if angle else 170), 430), ORIGIN, UPRIGHT, 0.10, width=2.6, size=15)
    panel(page, 660, 20, 300, 290, "In the equation of motion")
    page.text((810, 92), "M a + b = \u03c4 + J\u1d40 \u03bb", 23, INK, "middle", bold=True, halo=PANEL)
    page.lines((690, 150), ["\u03bb pushes on the robot, so", "it stands beside \u03c4, with a plus.", "",
                            "What the robot exerts on", "the table is \u2212\u03bb."], 16, MUTED, halo=PANEL)
    return page


# ---- 10. Split and Log6 ---------------------------------------------------------------

def planar_log(distance, angle):
    """Linear part, in Centered axes, of the logarithm of (turn `angle` about y, then displaced along x)."""
    # In the plane V(-angle)^-1 d = (angle/2) cot(angle/2) d + (angle/2) y x d.
    return (0.5 * angle / math.tan(0.5 * angle) * distance, 0.0, -0.5 * angle * distance)


def screw_path(distance, angle, steps=40):
    """The path of the tip under the constant twist that carries the reference to the tool."""
    radius = 0.5 * distance / math.sin(0.5 * angle)
    centre = (0.5 * distance, 0.0, -radius * math.cos(0.5 * angle))
    return [add(centre, turned(sub(ORIGIN, centre), Y, angle * k / steps)) for k in range(steps + 1)]


def errors():
    page = Page("errors", 980, 400, "Two position errors of a tool that has slid and turned on the plane")
    distance, angle = 0.20, 0.7
    split, log6 = (distance, 0.0, 0.0), planar_log(distance, angle)
    cases = (("Split", split, MOTION), ("Log6", log6, RED))
    for k, (heading, e, colour) in enumerate(cases):
        x = 20 + 480 * k
        panel(page, x, 20, 460, 360, heading)
        camera = side_view((x + 75, 240), 680)
        table(page, camera, 0.29, (0.23, 0, 0))
        tool(page, camera, ORIGIN, UPRIGHT, 0.62, opacity=0.35)
        tool(page, camera, (distance, 0, 0), UPRIGHT.then(Y, math.degrees(angle)), 0.62, opacity=0.8)
        page.text(camera((0, 0, 0.215)), "reference", 15, MUTED, "middle", halo=PANEL)
        path = [ORIGIN, split] if heading == "Split" else screw_path(distance, angle)
        page.polyline([camera(q) for q in path], INK, 2.2, "2 5")
        arrow(page, camera, split, e, colour, "e", 4.5, size=19)
        page.text((x + 230, 322), f"e_z = {signed(1000 * e[2])} mm", 19, INK, "middle", bold=True, halo=PANEL)
        words = "the tip is on the plane" + ("; the screw that leads there is not" if heading == "Log6" else "")
        page.text((x + 230, 352), words, 15, MUTED, "middle", halo=PANEL)
    return page


def main():
    folder = Path(__file__).resolve().parent
    for draw in (overview, local, centered, surface, curved, world, two_bodies, directions, drift, signs, errors):
        draw().write(folder)


if __name__ == "__main__":
    main()
