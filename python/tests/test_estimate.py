"""Estimation of the base of a robot on feet, in Python."""

import numpy as np
import pytest

import burnish


def standing():
    robot = burnish.load_robot("quadruped")
    return robot.model, robot.reference_configuration()


def options():
    return burnish.BaseEstimatorOptions(
        feet=[burnish.FootSpec(f"{leg}_foot") for leg in ("fl", "fr", "rl", "rr")]
    )


def test_base_estimator_at_rest_keeps_its_state():
    model, q = standing()
    estimator = burnish.BaseEstimator(model, options())
    estimator.reset(q)
    imu = burnish.ImuReading(accelerometer=[0.0, 0.0, 9.81])
    for _ in range(200):
        estimator.update(imu, q, np.zeros(model.nv), [True] * 4, 1e-3)
    assert np.allclose(estimator.q, q, atol=1e-6)
    assert np.allclose(estimator.v, 0.0, atol=1e-6)
    assert estimator.covariance.shape == (15, 15)
    assert estimator.feet_that_count == [True] * 4
    assert estimator.innovation.rows == 12


def test_base_estimator_with_invalid_input_raises():
    model, q = standing()
    estimator = burnish.BaseEstimator(model, options())
    imu = burnish.ImuReading(gyro=[np.nan, 0.0, 0.0])
    with pytest.raises(burnish.EvaluationError):
        estimator.update(imu, q, np.zeros(model.nv), [True] * 4, 1e-3)
    with pytest.raises(burnish.Error, match="wanted 4, one per foot"):
        estimator.update(burnish.ImuReading(), q, np.zeros(model.nv), [True], 1e-3)


def test_foot_contacts_detect_standing_feet_from_forces():
    model, _ = standing()
    contacts = burnish.FootContacts(model, 2, burnish.FootContactOptions(force_noise=0.1))
    weight = 9.81 * model.total_mass
    for _ in range(100):
        contacts.update([weight, 0.0], 1e-3)
    assert contacts.standing == [True, False]
