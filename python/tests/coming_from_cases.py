"""What test_coming_from.py runs: robots, states, problems and a controller."""

from __future__ import annotations

import functools
import inspect
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Callable, Dict, List, NamedTuple, Set, Tuple

import numpy as np

import burnish as bn
from burnish import residual
from dynamics_cases import MODEL, SOLES, TALOS, TIP, Array, state

ROOT = Path(__file__).parents[2]
Check = Callable[[], object]


class Row(NamedTuple):
    section: str
    theirs: str
    ours: str
    line: str


def rows_of_page() -> List[Row]:
    section, header, rows = "", [""], []
    for line in (ROOT / "docs/coming_from.md").read_text().splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if line.startswith("#"):
            section = line.strip("# ")
        if not line.startswith("|") or header == [""]:
            header = cells or [""]
        elif set(line) - set("| -:"):
            rows.append(Row(section, cells[0].replace("`", ""), cells[header.index("here")], line))
    return rows


# Robots and states. C, B and P make what the page calls cd, rb and problem; K is the arm at X; S is a solved problem.
Q, V, TAU = state()
A, REST = np.linspace(-1.0, 1.0, MODEL.nv), np.zeros(MODEL.nv)
ARM = bn.load_robot("arm7")
START = np.concatenate([ARM.posture("ready"), np.zeros(7)])
X, U = START + 0.1 * np.sin(np.arange(14.0)), np.arange(7.0) - 2.0
POINT, STEP, ONES = np.array([0.3, -0.1, 0.4]), 0.01, np.ones(7)
DONE = bn.StopReason.CONVERGED
IN_PLACE = bn.model.placement(POINT)
SIX = bn.ContactSpec("six", tool="tool", acceleration=bn.Acceleration.SPATIAL)


def close(a: Any, b: Any, tolerance: float = 1e-7) -> bool:
    return np.shape(a) == np.shape(b) and bool(np.allclose(a, b, tolerance, tolerance))


def default(spec: Any, **values: Any) -> bool:
    return all(getattr(spec, name) == value for name, value in values.items())


def C(*contacts: bn.ContactSpec, **entries: Any) -> bn.ContactDynamics:
    cd = bn.ContactDynamics(MODEL, contacts, **entries)
    assert cd.forward(Q, V, TAU) is bn.Status.OK and cd.forward_derivatives() is bn.Status.OK
    return cd


def inverse(*contacts: bn.ContactSpec, v: Array = V, a: Array = A, force: Any = ()) -> bn.ContactDynamics:
    cd = bn.ContactDynamics(MODEL, contacts)
    assert cd.inverse(Q, v, a, force) is bn.Status.OK and cd.inverse_derivatives() is bn.Status.OK
    return cd


def B(q: Array = Q, v: Array = V, a: Any = A, model: bn.Model = MODEL) -> bn.RigidBody:
    rb = bn.RigidBody(model)
    rb.update(q, v, a)
    rb.update_derivatives()
    return rb


def tool_rate(reference: Any) -> Array:
    """Returns d/dt of the tool's velocity in a reference, by differences."""
    h = 1e-6
    at = [B(bn.integrate(MODEL, Q, s * V), V + s * A).velocity("tool", reference) for s in (-h, h)]
    return (at[1] - at[0]) / (2.0 * h)


def P(*terms: Any, stage: Any = None, knots: int = 3, **entries: Any) -> bn.Problem:
    """Makes a problem of the arm from residuals, cost terms and constraints."""
    wrapped = [term if isinstance(term, (bn.CostTerm, bn.Constraint)) else bn.CostTerm(term) for term in terms]
    if not any(isinstance(term, bn.CostTerm) for term in wrapped):
        wrapped.append(bn.CostTerm(residual.State()))
    move = bn.Stage("move", costs=[term for term in wrapped if isinstance(term, bn.CostTerm)],
                    constraints=[term for term in wrapped if isinstance(term, bn.Constraint)], **(stage or {}))
    entries.setdefault("horizon", [bn.HorizonSegment("move", knots)])
    entries["stages"] = [move, *entries.get("stages", [])]
    return bn.Problem(bn.ProblemSpec(ARM.model, **{"initial_state": START, **entries}))


def value(term: Any) -> Array:
    return P(term).residual(0, 0, X, U)


def cost(term: Any, weight: float = 1.0, **entries: Any) -> float:
    return P(bn.CostTerm(term, weight, **entries)).term_costs(0, X, U)[0] / STEP


def K(x: Array = X) -> bn.RigidBody:
    return B(x[:7], x[7:], None, ARM.model)


def spot(frame: str) -> Array:
    return K().placement(frame)[:3, 3]


class Acceleration:
    name, rows = "acceleration", 7

    def value(self, at: bn.NodeView) -> Array:
        return at.acceleration


@functools.lru_cache(maxsize=None)
def feet() -> SimpleNamespace:
    """Talos on both feet, pushed: rows of cones and pressures, and the force of the left foot."""
    soles = [sole.replace(reference=bn.Reference.local()) for sole in SOLES]
    terms: Dict[str, Any] = dict(
        pyramid=residual.FrictionCone("left", 0.6, sides=4), cone=residual.FrictionCone("left", 0.6),
        pressure=residual.CenterOfPressure("left", 0.1, 0.05, 0.4), force=residual.ContactForce("left"))
    stand = bn.Stage("stand", contacts=["left", "right"], costs=[bn.CostTerm(r, name=n) for n, r in terms.items()])
    land = bn.Stage("land", contacts=["left", "right"], impact=True)
    x = np.concatenate([TALOS.reference_configuration(), np.zeros(TALOS.model.nv)])
    problem = bn.Problem(bn.ProblemSpec(
        TALOS.model, contacts=soles, stages=[stand, land], initial_state=x,
        terminal=[bn.CostTerm(residual.CentroidalMomentum())],
        horizon=[bn.HorizonSegment("stand"), bn.HorizonSegment("land")]))
    still = problem.quasi_static("stand", x)
    u = still.control + 5.0 * np.sin(np.arange(30.0))
    force = problem.forces(0, x, u)[:6]
    L, W, mu, (fx, fy, fz, mx, my, mz) = 0.1, 0.05, 0.4, force
    turns = [mu * (L + W) * fz - a * W * fx - b * L * fy - s * (mu * a * mx + mu * b * my + mz)
             for s in (-1, 1) for a in (-1, 1) for b in (-1, 1)]
    moving = problem.integrate(x, np.concatenate([np.zeros(36), 0.1 * np.ones(36)]))
    landed = problem.roll(1, moving)[0]
    assert landed is not None
    return SimpleNamespace(problem=problem, x=x, f=force, still=still, turns=np.sort(turns), landed=landed,
                           after=B(landed[:37], landed[37:], None, TALOS.model),
                           **{name: problem.residual(0, name, x, u) for name in terms})


@functools.lru_cache(maxsize=None)
def S() -> SimpleNamespace:
    seen: List[bn.DdpProgress] = []
    speed = bn.Constraint(residual.JointVelocity(), name="speed", lower=-0.8, upper=0.8)
    problem = P(bn.CostTerm(residual.State(), 0.1), bn.CostTerm(residual.Control(), 1e-3), speed, knots=40,
                terminal=[bn.CostTerm(residual.FramePosition("tool", [0.55, -0.15, 0.35]), 1e4, "goal")])
    solver = bn.DdpSolver(problem, bn.DdpOptions(callback=lambda progress: seen.append(progress)))
    return SimpleNamespace(problem=problem, solver=solver, summary=solver.solve(), seen=seen)


def solve(problem: bn.Problem, **options: Any) -> bn.DdpSummary:
    return bn.DdpSolver(problem, bn.DdpOptions(**options)).solve()


def answered() -> bool:
    """Returns whether a gain is the derivative of the control, about a rest where Gauss-Newton is exact."""
    hold = P(residual.State()).quasi_static("move", START).control
    problem, us = P(bn.CostTerm(residual.State(), 1.0), bn.CostTerm(residual.Control(hold), 1e-2), knots=20), []
    for h in (0.0, -1e-4, 1e-4):
        problem.set_initial_state(problem.integrate(START, h * np.eye(14)[3]))
        solver = bn.DdpSolver(problem)
        solver.set_guess(np.tile(START, (21, 1)), np.tile(hold, (20, 1)))
        assert solver.solve().reason is bn.StopReason.CONVERGED
        us.append((np.array(solver.us[0]), solver.gain(0)[:, 3]))
    return close((us[2][0] - us[1][0]) / 2e-4, us[0][1], 1e-3)


def soft(l1: float, quadratic: float = 0.0) -> float:
    """Returns the violation of a soft limit of 1 Nm at one knot whose cost is (u - 3)^2 / 2 per second."""
    wish = bn.CostTerm(residual.Control(3.0 * np.ones(7)), 1.0)
    limit = bn.Constraint(residual.Control(), "limit", upper=1.0, scale=1.0, l1_weight=l1, quadratic_weight=quadratic)
    solver = bn.DdpSolver(P(wish, limit, knots=1))
    assert solver.solve().reason is bn.StopReason.CONVERGED
    return float(solver.us[0, 0]) - 1.0


@functools.lru_cache(maxsize=None)
def control() -> SimpleNamespace:
    """Runs a controller in a closed loop."""
    costs = [bn.CostTerm(residual.State(START), 1.0), bn.CostTerm(residual.Control(), 1e-4)]
    stages = [bn.Stage(name, costs=costs) for name in ("one", "two")]
    problem = bn.ProblemSpec(ARM.model, stages=stages, horizon=[bn.HorizonSegment("one", 10)], initial_state=START)
    spec = bn.MpcSpec(problem, schedule=[bn.SchedulePhase("a", "one", 0.02), bn.SchedulePhase("b", "two")],
                      tick_period=1e-3, update_period=5e-3)
    tip = bn.with_surface_at(ARM.model, START[:7], [0, 0, 1], bn.TouchSpec("tool"), clearance=0.1)
    plant = bn.make_ideal_plant(ARM.model, bn.SceneSpec([tip]))
    loop = bn.ClosedLoop(plant, bn.MpcController(spec))
    loop.reset(START[:7])
    assert loop.run(0.04) is bn.Status.OK
    return SimpleNamespace(spec=spec, loop=loop, controller=loop.controller, command=loop.command)


def joined() -> bn.Model:
    tree, other = (bn.read_urdf(next(p for p in bn.robot_search_path() if (p / n).is_dir()) / n / f"{n}.urdf")
                   for n in ("arm7", "pendulum"))
    other.links[0].name = other.joints[0].parent_link = "post"
    tree.links, mount = tree.links + other.links, bn.JointSpec("mount", parent_link="flange", child_link="post")
    tree.joints = [*tree.joints, *other.joints, mount]
    return bn.build_model(tree)


def free_arm() -> bn.ContactDynamics:
    cd = bn.ContactDynamics(ARM.model)
    cd.forward(X[:7], X[7:], U)
    return cd


def inactive() -> bn.ContactDynamics:
    cd = bn.ContactDynamics(MODEL, [TIP])
    cd.set_active("tip", False)
    cd.forward(Q, V, TAU)
    return cd


def accelerated() -> bn.ContactDynamics:
    cd = bn.ContactDynamics(MODEL, [TIP])
    cd.acceleration(Q, V, A)
    cd.acceleration_derivatives()
    return cd


def theta() -> Array:
    """Returns the inertia parameters of all bodies."""
    bodies = [bn.InertiaSpec(joint.mass, joint.com, joint.inertia_at_com) for joint in MODEL.joints]
    return np.concatenate([bn.identification.inertia_parameters(body) for body in bodies])


def bounded() -> bn.Problem:
    return P(residual.State(), residual.Control(), control_lower=-1.0, control_upper=1.0)


def restaged() -> bn.Problem:
    other = bn.Stage("other", costs=[bn.CostTerm(residual.Control())])
    problem = P(residual.State(), stages=[other])
    problem.set_knot(0, "other", 0.0)
    return problem


def rolled(**stage: Any) -> Array:
    after = P(residual.State(), stage=stage).roll(0, X, U)[0]
    assert after is not None
    return after


def along(problem: bn.Problem) -> Any:
    """Returns the states and controls of a trajectory that stays at one state."""
    return np.tile(X, (problem.knots + 1, 1)), np.tile(U, (problem.knots, 1))


def guessed() -> bn.DdpSolver:
    solver = bn.DdpSolver(S().problem)
    solver.set_guess(S().solver.xs, S().solver.us)
    return solver


def slope() -> float:
    """Returns the derivative of the optimal cost by the position of joint 4 at the start."""
    costs, h = [], 1e-4
    for side in (-h, h):
        problem = bn.Problem(S().problem.spec)
        problem.set_initial_state(problem.integrate(START, side * np.eye(14)[3]))
        costs.append(solve(problem).cost)
    return (costs[1] - costs[0]) / (2.0 * h)


def growing() -> bn.Problem:
    return P(residual.Control(), horizon=[bn.HorizonSegment("move", 5, 0.01, 0.1)])


def slow() -> bn.Problem:
    return P(residual.State(), torque_model=bn.TorqueModel(60.0), initial_state=[*START, *U])


def ticked() -> bn.Command:
    time = control().loop.measurement.time + 1e-3
    command: bn.Command = control().controller.tick(bn.Measurement(time=time, q=START[:7], v=np.zeros(7)))
    return command


def order() -> bn.JointOrder:
    return bn.JointOrder.mujoco(floating())


def outside() -> bn.DdpSummary:
    fast = np.concatenate([START[:7], np.ones(7)])
    return solve(P(residual.State(), residual.Control(), bn.Constraint(residual.JointVelocity(), upper=0.5),
                   initial_state=fast), max_iterations=3)


def multiplier(wish: float) -> float:
    """Returns the multiplier of limits of 1 Nm for a control that wishes to be elsewhere."""
    limit = bn.Constraint(residual.Control(), "limit", -1.0, 1.0)
    solver = bn.DdpSolver(P(bn.CostTerm(residual.Control(wish * np.ones(7))), limit, knots=1))
    solver.solve()
    return float(solver.multipliers(0)[0])


def wheel(kind: str, mass: float = 1.0) -> bn.Model:
    return bn.build_model(bn.parse_urdf(
        f'''<robot name="wheel"><link name="a"/><joint name="j" type="{kind}"><parent link="a"/><child link="b"/>
        <axis xyz="0 0 1"/></joint><link name="b"><inertial><mass value="{mass}"/>
        <inertia ixx="{mass}" iyy="{mass}" izz="{mass}" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'''))


def floating() -> bn.Model:
    """Returns a floating body with a hinge, from MJCF."""
    return bn.build_model(bn.parse_mjcf(
        '''<mujoco><worldbody><body name="base"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        <body name="arm"><joint name="hinge" axis="0 0 1"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        </body></body></worldbody></mujoco>'''))


# A base that is turned by 90 degrees about z.
TURNED = np.array([0.0, 0.0, 0.0, 0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5), 0.0])


def free_joint_rates() -> Tuple[Array, Array]:
    """Returns d/dt of MuJoCo's velocity, by differences, and T a + c."""
    model, h, v, a = floating(), 1e-6, np.arange(1.0, 8.0), np.cos(np.arange(7.0))
    at = [order().v_to(v + s * a, bn.integrate(model, TURNED, s * v)) for s in (-h, h)]
    turn = B(TURNED, v, None, model).placement("base")[:3, :3]
    c = np.concatenate([turn @ np.cross(v[3:6], v[:3]), np.zeros(4)])
    return (at[1] - at[0]) / (2.0 * h), order().v_to(a, TURNED) + c


def siblings(model: bn.Model) -> List[List[str]]:
    """Returns the names of the joints with the same parent, in the order of the model."""
    return [[joint.name for joint in model.joints if joint.parent == body] for body in range(len(model.joints))]


def refusal(function: Any) -> str:
    """Returns the sentence with which a function refuses."""
    try:
        function()
    except bn.Error as error:
        return str(error)
    return ""


def runs(function: Callable[..., object], *arguments: object) -> bool:
    function(*arguments)
    return True


@functools.lru_cache(maxsize=None)
def snake_names() -> str:
    return "_".join(["", *(re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower() for name in NAMES), ""])


def absent(*words: str) -> Check:
    """Checks that no public name has one of the words: the page says "none"."""
    return lambda: not [word for word in words if f"_{word}_" in snake_names()]


def members(thing: Any) -> Set[str]:
    fields = set(getattr(thing, "__dataclass_fields__", {}))
    return fields | {name for name in dir(thing) if not name.startswith("_")}


PLACES: List[Any] = [bn, residual, bn.plot, bn.polishing]
NAMES = {name for place in PLACES for name in members(place)} | {
    name for place in PLACES for thing in vars(place).values() if inspect.isclass(thing) for name in members(thing)}

# What the page calls an object, and its class or module.
OBJECTS: Dict[str, Any] = {
    "cd": bn.ContactDynamics, "rb": bn.RigidBody, "model": bn.Model, "robot": bn.Robot, "problem": bn.Problem,
    "solver": bn.DdpSolver, "summary": bn.DdpSummary, "controller": bn.MpcController, "residual": residual,
    "plot": bn.plot}


def unknown_names(row: Row, known_names: Set[str]) -> List[str]:
    """Returns the names of our cell that are not in `known_names`, and not the other library's."""
    code = re.sub(r'"[^"]*"', "", " ".join(re.findall(r"`([^`]+)`", row.ours)))
    everything = known_names | set(re.findall(r"\w+", row.line.replace(row.ours, "")))
    unknown = []
    for chain in re.findall(r"[A-Za-z_]\w*(?:(?:\.|::)[A-Za-z_]\w*)*", code):
        first, *rest = re.split(r"\.|::", chain)
        owner = OBJECTS.get(first, getattr(bn, first, None))
        known = members(owner) if owner is not None and "::" not in chain else everything
        unknown += [chain for name in rest[:1] if not {name, name + "_"} & known]
        unknown += [chain for name in [first, *rest[1:]] if name not in everything]
    return unknown
