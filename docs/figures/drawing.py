"""What the figures are drawn with: small vectors, a camera, and an SVG page.

Lengths are metres in the scene and pixels on the page. A Camera carries one to
the other, so a scene is described once, in the world, and never in pixels.
Colours are those of Okabe and Ito, which colour-blind readers can tell apart.
"""

import math
import re
from pathlib import Path

INK, MUTED, FAINT = "#1F2933", "#52606D", "#B8C2CC"
AXES = ("#D55E00", "#009E73", "#0072B2")  # x, y, z
FORCE, MOTION = "#A8437F", "#E69F00"      # a darker shade of the purple, for thin strokes
TOOL_LIGHT, TOOL_DARK, TOOL_EDGE = "#F1F4F7", "#A9B4C0", "#6B7885"
BOARD_TOP, BOARD_SIDE, BOARD_EDGE = "#F5E9CF", "#E0CDA3", "#B49B66"
PANEL = "#F6F8FA"
WRONG = "7 5"                             # the dash pattern of everything that is wrong

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)


# ---- vectors and rotations ------------------------------------------------------------

def add(a, b):
    return tuple(p + q for p, q in zip(a, b))


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def scale(s, a):
    return tuple(s * p for p in a)


def along(a, s, b):
    """The point a + s b."""
    return add(a, scale(s, b))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scale(1.0 / length(a), a)


def turned(v, axis, angle):
    """v turned by `angle` radians about the unit vector `axis` (Rodrigues)."""
    c, s = math.cos(angle), math.sin(angle)
    return add(add(scale(c, v), scale(s, cross(axis, v))), scale((1 - c) * dot(axis, v), axis))


class Rotation:
    """A rotation, kept as the images of x, y and z."""

    def __init__(self, columns=(X, Y, Z)):
        self.columns = columns

    def __call__(self, v):
        total = ORIGIN
        for component, column in zip(v, self.columns):
            total = along(total, component, column)
        return total

    def then(self, axis, degrees):
        """This rotation followed by one of `degrees` about the fixed `axis`."""
        return Rotation(tuple(turned(c, axis, math.radians(degrees)) for c in self.columns))


UPRIGHT = Rotation()


# ---- the camera -----------------------------------------------------------------------

class Camera:
    """A parallel projection; `at` is the pixel of the scene's origin."""

    def __init__(self, at, pixels_per_metre, azimuth=-62.0, elevation=20.0):
        ca, sa = math.cos(math.radians(azimuth)), math.sin(math.radians(azimuth))
        ce, se = math.cos(math.radians(elevation)), math.sin(math.radians(elevation))
        self.at, self.zoom = at, pixels_per_metre
        self.right, self.up = (-sa, ca, 0.0), (-se * ca, -se * sa, ce)
        self.to_eye = (ce * ca, ce * sa, se)

    def __call__(self, p):
        return (self.at[0] + self.zoom * dot(self.right, p), self.at[1] - self.zoom * dot(self.up, p))


def side_view(at, pixels_per_metre):
    """x to the right, z up, y away from the reader."""
    return Camera(at, pixels_per_metre, azimuth=-90.0, elevation=0.0)


# ---- the page -------------------------------------------------------------------------

def number(value):
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def subscripts(text, size):
    """Turns a_z or a_{ref} into a lowered tspan; leaves the names of functions, as in pad_z()."""
    def lowered(match):
        small, drop = number(0.8 * size), number(0.25 * size)
        inner = match.group(1) or match.group(2)
        return f'<tspan font-size="{small}" dy="{drop}">{inner}</tspan><tspan dy="-{drop}">\u200b</tspan>'
    return re.sub(r"(?<![A-Za-z]{2})_(?:\{([^}]*)\}|(\w))", lowered, escape(text))


def pairs(points):
    return " ".join(f"{number(x)},{number(y)}" for x, y in points)


class Page:
    """One SVG file: its own white card, and a list of shapes."""

    def __init__(self, name, width, height, title):
        self.name, self.width, self.height, self.title = name, width, height, title
        self.shapes, self.defs = [], []

    def put(self, shape):
        self.shapes.append(shape)

    def polygon(self, points, fill, edge="none", width=1.2, opacity=1.0):
        self.put(f'<polygon points="{pairs(points)}" fill="{fill}" stroke="{edge}" '
                 f'stroke-width="{width}" stroke-linejoin="round" opacity="{opacity}"/>')

    def polyline(self, points, colour=INK, width=2.0, dash="", opacity=1.0):
        pattern = f' stroke-dasharray="{dash}"' if dash else ""
        self.put(f'<polyline points="{pairs(points)}" fill="none" stroke="{colour}" stroke-width="{width}" '
                 f'stroke-linejoin="round" stroke-linecap="round" opacity="{opacity}"{pattern}/>')

    def circle(self, at, radius, fill=INK, edge="none", width=1.5):
        self.put(f'<circle cx="{number(at[0])}" cy="{number(at[1])}" r="{number(radius)}" '
                 f'fill="{fill}" stroke="{edge}" stroke-width="{width}"/>')

    def box(self, x, y, width, height, fill=PANEL, edge="none", radius=10):
        self.put(f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" '
                 f'rx="{radius}" fill="{fill}" stroke="{edge}"/>')

    def text(self, at, text, size=15, colour=INK, anchor="start", bold=False, halo="white"):
        """`at` is the middle of the text's height; the halo keeps it readable over lines."""
        weight = ' font-weight="600"' if bold else ""
        self.put(f'<text x="{number(at[0])}" y="{number(at[1] + 0.35 * size)}" font-size="{size}" '
                 f'fill="{colour}" text-anchor="{anchor}"{weight} stroke="{halo}" stroke-width="4" '
                 f'stroke-linejoin="round" paint-order="stroke">{subscripts(text, size)}</text>')

    def lines(self, at, texts, size=15, colour=INK, anchor="start", bold=False, halo="white"):
        for row, text in enumerate(texts):
            self.text((at[0], at[1] + 1.4 * size * row), text, size, colour, anchor, bold, halo)

    def head(self, tip, direction, colour, size):
        """The filled triangle of an arrow that ends at `tip`."""
        n = math.hypot(*direction)
        dx, dy = direction[0] / n, direction[1] / n
        back = (tip[0] - size * dx, tip[1] - size * dy)
        side = (-0.42 * size * dy, 0.42 * size * dx)
        self.polygon([tip, (back[0] + side[0], back[1] + side[1]), (back[0] - side[0], back[1] - side[1])], colour)
        return back

    def arrow(self, tail, tip, colour=INK, width=3.0, dash=""):
        """From pixel to pixel."""
        size = min(6.0 + 3.0 * width, 0.6 * math.dist(tail, tip))
        back = self.head(tip, (tip[0] - tail[0], tip[1] - tail[1]), colour, size)
        self.polyline([tail, back], colour, width, dash)

    def write(self, folder):
        card = (f'<rect x="1" y="1" width="{self.width - 2}" height="{self.height - 2}" rx="16" '
                f'fill="white" stroke="#D5DBE1"/>')
        body = "\n".join([f"<title>{escape(self.title)}</title>", "<defs>", *self.defs, "</defs>", card, *self.shapes])
        Path(folder, self.name + ".svg").write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
            f'width="{self.width}" height="{self.height}" role="img" '
            f'font-family="Helvetica, Arial, \'DejaVu Sans\', sans-serif">\n{body}\n</svg>\n', encoding="utf-8")


def panel(page, x, y, width, height, heading, colour=INK):
    page.box(x, y, width, height)
    page.text((x + width / 2, y + 24), heading, 17, colour, "middle", bold=True, halo=PANEL)


# ---- things in the scene --------------------------------------------------------------

def arrow(page, camera, tail, vector, colour, text="", width=3.5, dash="", size=16, aside=(0, 0), halo=PANEL):
    """An arrow from a point of the scene; its label stands beyond the tip, moved by `aside` pixels."""
    start, end = camera(tail), camera(add(tail, vector))
    page.arrow(start, end, colour, width, dash)
    if text:
        reach = math.dist(start, end)
        beyond = [e + 15 * (e - s) / reach + a for s, e, a in zip(start, end, aside)]
        page.text(beyond, text, size, colour, "middle", bold=True, halo=halo)


def triad(page, camera, at, rotation, reach, names=("x", "y", "z"), width=3.5, size=16, hide=0.15, halo=PANEL):
    """Three axes, the far ones first; an axis that points at the reader, or away, is left out.

    `reach` is one length, or one for each axis.
    """
    reaches = (reach,) * 3 if isinstance(reach, float) else reach
    axes = sorted(range(3), key=lambda i: dot(camera.to_eye, rotation.columns[i]))
    for i in axes:
        axis = rotation.columns[i]
        if abs(dot(camera.to_eye, axis)) < 1 - hide:
            arrow(page, camera, at, scale(reaches[i], axis), AXES[i], names[i], width, size=size, halo=halo)
    page.circle(camera(at), width + 0.8, INK)


def turn(page, camera, centre, axis, radius, start, degrees, colour, width=3.0, dash=""):
    """An arc with a head: a rotation about `axis`, from the direction `start`; returns its middle."""
    first, steps = scale(radius, unit(start)), 40
    points = [camera(add(centre, turned(first, unit(axis), math.radians(degrees * k / steps))))
              for k in range(steps + 1)]
    tip, before = points[-1], points[-5]
    page.head(tip, (tip[0] - before[0], tip[1] - before[1]), colour, 6 + 2.4 * width)
    page.polyline(points[:-3], colour, width, dash)
    return points[steps // 2]


def hull(points):
    """Convex hull (Andrew's monotone chain): the silhouette of a convex body."""
    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1])
                                      <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])):
                chain.pop()
            chain.append(p)
        return chain[:-1]
    ordered = sorted(points)
    return half(ordered) + half(ordered[::-1])


def ring(centre, rotation, radius, count=36):
    return [add(centre, rotation((radius * math.cos(a), radius * math.sin(a), 0.0)))
            for a in (2 * math.pi * k / count for k in range(count))]


def shading(page, camera, centre, rotation, radius, light=TOOL_LIGHT, dark=TOOL_DARK):
    """A gradient across a body of revolution; returns the paint."""
    across = cross(rotation(Z), camera.to_eye)
    across = unit(across) if length(across) > 1e-6 else camera.right
    (x1, y1), (x2, y2) = camera(along(centre, -radius, across)), camera(along(centre, radius, across))
    name = f"shade{len(page.defs)}"
    page.defs.append(
        f'<linearGradient id="{name}" gradientUnits="userSpaceOnUse" x1="{number(x1)}" y1="{number(y1)}" '
        f'x2="{number(x2)}" y2="{number(y2)}"><stop offset="0" stop-color="{dark}"/>'
        f'<stop offset="0.45" stop-color="{light}"/><stop offset="1" stop-color="{dark}"/></linearGradient>')
    return f"url(#{name})"


TAPERED = ((0.0, 0.004, 0.09, 0.030), (0.09, 0.044, 0.24, 0.056), (0.24, 0.066, 0.30, 0.066))


def tool(page, camera, tip, rotation, size=1.0, opacity=1.0, edge=TOOL_EDGE):
    """A stack of cut cones on the tool's z axis; the tip is the contact frame's origin."""
    upwards = dot(camera.to_eye, rotation(Z)) >= 0
    page.put(f'<g opacity="{opacity}">')
    for low, r_low, high, r_high in (TAPERED if upwards else TAPERED[::-1]):
        base, top = (along(tip, size * h, rotation(Z)) for h in (low, high))
        paint = shading(page, camera, base, rotation, size * max(r_low, r_high))
        rim = [camera(p) for p in ring(top if upwards else base, rotation, size * (r_high if upwards else r_low))]
        page.polygon(hull([camera(p) for p in ring(base, rotation, size * r_low)]
                          + [camera(p) for p in ring(top, rotation, size * r_high)]), paint, edge)
        if abs(dot(camera.to_eye, rotation(Z))) > 0.05:
            page.polygon(rim, TOOL_LIGHT if upwards else TOOL_DARK, edge)
    page.put("</g>")


def board(page, camera, centre, rotation, half=(0.3, 0.2), thick=0.03, opacity=1.0):
    """A slab whose upper face has its middle at `centre`."""
    middle = along(centre, -0.5 * thick, rotation(Z))
    size = (half[0], half[1], 0.5 * thick)
    page.put(f'<g opacity="{opacity}">')
    for i in range(3):
        for sign in (-1.0, 1.0):
            normal = scale(sign, rotation.columns[i])
            if dot(camera.to_eye, normal) > 1e-9:
                j, k = (i + 1) % 3, (i + 2) % 3
                face = along(middle, size[i], normal)
                corners = [along(along(face, a * size[j], rotation.columns[j]), b * size[k], rotation.columns[k])
                           for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                page.polygon([camera(c) for c in corners], BOARD_TOP if i == 2 else BOARD_SIDE, BOARD_EDGE)
    page.put("</g>")


def disc(page, camera, centre, rotation, radius, thick=0.03):
    """A round slab whose upper face has its middle at `centre`."""
    upper = [camera(p) for p in ring(centre, rotation, radius, 72)]
    lower = [camera(p) for p in ring(along(centre, -thick, rotation(Z)), rotation, radius, 72)]
    page.polygon(hull(upper + lower), BOARD_SIDE, BOARD_EDGE)
    page.polygon(upper, BOARD_TOP, BOARD_EDGE)
