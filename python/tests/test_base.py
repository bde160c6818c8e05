"""Errors and statuses."""

from __future__ import annotations

import pytest

import burnish


def test_error_classes_derive_from_value_error() -> None:
    assert issubclass(burnish.Error, ValueError)
    assert issubclass(burnish.EvaluationError, burnish.Error)
    assert burnish.Error.__doc__ and burnish.EvaluationError.__doc__


def test_unknown_name_raises_one_sentence_with_the_nearest() -> None:
    robot = burnish.load_robot("arm7")
    with pytest.raises(burnish.Error, match="did you mean 'bent'") as refused:
        robot.posture("bentt")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("status", burnish.Status)
def test_every_status_has_a_description(status: burnish.Status) -> None:
    sentence = burnish.describe(status)
    assert sentence and "\n" not in sentence
    assert burnish.describe(status.name.lower()) == sentence
    assert burnish.describe(status.name) == sentence


def test_unknown_status_raises_with_the_nearest() -> None:
    with pytest.raises(burnish.Error, match="Status: there is no 'not_finit'; did you mean 'not_f"):
        burnish.describe("not_finit")


def test_returned_status_is_the_enum_member() -> None:
    robot = burnish.load_robot("pendulum")
    dynamics = burnish.ContactDynamics(robot.model)
    q, zero = robot.reference_configuration(), [0.0] * robot.model.nv
    assert dynamics.forward(q, zero, zero) is burnish.Status.OK
