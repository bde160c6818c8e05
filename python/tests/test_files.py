"""Problem files in Python."""

import pickle
import re
from pathlib import Path

import numpy as np
import pytest

import burnish as bn
from burnish import residual

PROBLEMS = Path(__file__).parents[2] / "examples" / "problems"


@pytest.mark.parametrize("file", sorted(PROBLEMS.glob("*.yaml")), ids=lambda file: file.stem)
def test_problem_file_is_read_and_evaluates(file):
    read = bn.read_problem_file(file)
    assert read.description and read.spec.model.name == read.robot.model.name
    problem = bn.Problem(read.spec)
    guess = bn.make_guess(problem, read.guess)
    assert guess.xs.shape == (problem.knots + 1, problem.nx)
    assert guess.us.shape == (problem.knots, problem.max_controls)
    np.testing.assert_array_equal(guess.xs[0], problem.initial_state)
    assert np.isfinite(problem.evaluate(guess.xs, guess.us).cost)


def test_problem_file_solves():
    read = bn.read_problem_file(str(PROBLEMS / "reaching.yaml"))
    problem = bn.Problem(read.spec)
    solver = bn.DdpSolver(problem, read.solver)
    solver.set_guess(*vars(bn.make_guess(problem, read.guess)).values())
    assert solver.solve().reason is bn.StopReason.CONVERGED
    options = read.solver.replace(max_iterations=1)
    assert bn.DdpSolver(problem, options).solve().iterations == 1
    assert read.solver.max_iterations != 1


def signals_of(spec):
    terms = [term for stage in spec.stages for term in stage.costs] + spec.terminal
    return [term.residual.target for term in terms if hasattr(term.residual, "target")]


def test_signals_over_time_are_functions():
    spec = bn.read_problem_file(PROBLEMS / "polishing.yaml").spec
    moving = [signal for signal in signals_of(spec) if isinstance(signal, bn.OverTime)]
    assert moving
    for signal in moving:
        assert signal.function(0.1).shape == (signal.size,)
    # A spec that went through Python gives the same problem.
    xs = bn.make_guess(bn.Problem(spec)).xs
    us = bn.make_guess(bn.Problem(spec)).us
    again = bn.Problem(spec).spec
    np.testing.assert_array_equal(
        bn.Problem(again).evaluate(xs, us).costs, bn.Problem(spec).evaluate(xs, us).costs
    )


def test_spec_of_a_file_can_be_changed(tmp_path):
    spec = bn.read_problem_file(PROBLEMS / "reaching.yaml").spec
    spec.terminal.append(bn.CostTerm(residual.Control(), name="none"))
    spec.terminal.pop()
    spec.horizon[0].knots = 12
    assert bn.Problem(spec).knots == 12 + sum(segment.knots for segment in spec.horizon[1:])
    if not any(isinstance(signal, bn.OverTime) for signal in signals_of(spec)):
        bn.Problem(pickle.loads(pickle.dumps(spec)))


def test_invalid_file_raises_with_the_nearest_key(tmp_path):
    with pytest.raises(bn.Error, match="nothing.yaml"):
        bn.read_problem_file(tmp_path / "nothing.yaml")
    text = (PROBLEMS / "reaching.yaml").read_text()
    key = re.search(r"^(stages|horizon|terminal):", text, re.M).group(1)
    broken = tmp_path / "broken.yaml"
    broken.write_text(text.replace(f"\n{key}:", f"\n{key}x:"))
    with pytest.raises(bn.Error, match=f"broken.yaml.*{key}x.*did you mean '{key}'"):
        bn.read_problem_file(broken)


def test_guess_is_static_or_without_controls():
    read = bn.read_problem_file(PROBLEMS / "reaching.yaml")
    problem = bn.Problem(read.spec)
    hold, still = bn.make_guess(problem), bn.make_guess(problem, bn.WarmStart("still"))
    assert not still.us.any() and hold.us.any()
    np.testing.assert_array_equal(hold.xs, still.xs)
    np.testing.assert_allclose(
        hold.us[0], problem.quasi_static(problem.stage_of(0), problem.initial_state).control
    )
    with pytest.raises(bn.Error, match="nowhere.csv"):
        bn.make_guess(problem, bn.WarmStart(bn.WarmStartKind.FILE, "nowhere.csv"))


def test_read_trace_gives_columns_without_units(tmp_path):
    file = tmp_path / "trace.csv"
    file.write_text("time [s],q_joint_1 [rad],row\n0,0.5,speed/joint_1\n0.1,,speed/joint_2\n")
    table = bn.read_trace(file)
    assert list(table) == ["time", "q_joint_1", "row"]
    np.testing.assert_array_equal(table["time"], [0.0, 0.1])
    assert table["q_joint_1"][0] == 0.5 and np.isnan(table["q_joint_1"][1])
    assert table["row"][1] == "speed/joint_2"
    file.write_text("time [s],x [m]\n0\n")
    with pytest.raises(bn.Error, match="line 2 has 1 cells; the header has 2"):
        bn.read_trace(file)
