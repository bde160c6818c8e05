"""docs/coming_from.md: the burnish side of every row runs on a robot, and every name in it exists."""

from __future__ import annotations

import re
from typing import Dict

import numpy as np
import pytest

import burnish as bn
from burnish import residual as r
from coming_from_cases import (
    A, B, C, DONE, IN_PLACE, K, NAMES, OBJECTS, ONES, P, POINT, Q, REST, ROOT, S, SIX, START, STEP, TAU, TURNED, U,
    V, X, absent, accelerated, Acceleration, along, answered, bounded, Check, close, control, cost, default, feet,
    floating, free_arm, free_joint_rates, growing, guessed, inactive, inverse, joined, multiplier, order, outside,
    refusal, restaged, rolled, Row, rows_of_page, runs, siblings, slope, slow, soft, solve, spot, theta, ticked,
    tool_rate, unknown_names, value, wheel)
from dynamics_cases import MODEL, ROBOT, TALOS, TIP, differences

# Per heading: start of the first cell (several: joined by " & ") and a check, which must not be false.
CHECKS: Dict[str, Dict[str, Check]] = {
    "Models and configurations": {
        "Model, Data": lambda: C().nv == B().nv == MODEL.nv,
        "urdf::buildModel": lambda: TALOS.model.joints[0].nq == 7 and bn.ModelOptions(base=bn.Base.FREE_FLYER),
        "buildReducedModel": lambda: MODEL.locked_joints and bn.ModelOptions(locked=["a"], posture={"a": [1.0]}),
        "appendModel": lambda: joined().nv == 8 and bn.with_payload(MODEL, "tool",
            bn.InertiaSpec(1.0)).total_mass > MODEL.total_mass,
        "model.getFrameId": lambda: MODEL.frames[MODEL.frame_index("tool")].name == "tool"
            and MODEL.joint_index(MODEL.joints[1].name) == 1,
        "joint index 0": lambda: MODEL.joints[0].parent == -1,
        "srdf": lambda: close(ROBOT.posture("tilt_45"), bn.configuration(MODEL, ROBOT.postures["tilt_45"])),
        "neutral": lambda: close(bn.integrate(MODEL, MODEL.q_neutral, bn.difference(MODEL, MODEL.q_neutral, Q)), Q),
        "integrateCoeff": lambda: close(bn.tangent_map(MODEL, Q), differences(lambda h: bn.integrate(MODEL, Q, h),
            MODEL.nv)),
        "dIntegrate": absent("dintegrate", "ddifference"),
        "interpolate": lambda: close(bn.difference(MODEL, Q, bn.integrate(MODEL, Q, 0.5 * V)), 0.5 * V),
        "randomConfig": lambda: runs(bn.check_configuration, TALOS.model, bn.random_configuration(TALOS.model, 3)),
        "normalize": lambda: runs(bn.check_configuration, MODEL, bn.normalized(MODEL, Q)),
        "log6": lambda: absent("exp6", "log3", "exp3")() and close(B().placement_error("tool", B().placement("tool")),
            np.zeros(6)) and B().placement_derivatives("tool", np.eye(4)),
        "GeometryModel": absent("compute_collision", "collides"),
        "model.cast": absent("casadi", "cppad"),
    },
    "Kinematics": {
        "forwardKinematics & updateFrame": lambda: close(B().placement("tool"), bn.frame_placement(MODEL, Q, "tool"))
            and len(bn.frame_placements(MODEL, Q)) == len(MODEL.frames),
        "getFrameVelocity( & computeJointJacobians": lambda: all(close(B().frame_derivatives("tool", axes).jacobian @ V,
            B().velocity("tool", axes)) for axes in ("local", "centered", "world")),
        "getFrameAcceleration:": lambda: all(close(B().acceleration("tool", axes), tool_rate(axes), 1e-4)
            for axes in (bn.Reference.local(), bn.Reference.world())),
        "getFrameClassical": lambda: close(B().acceleration("tool", bn.Reference.centered()), tool_rate("centered"),
            1e-4),
        "getJointJacobian": lambda: B().frame_derivatives(MODEL.joints[2].name, "local").jacobian.any(),
        "getFrameJacobianTime": lambda: absent("time_variation")() and close(B(a=None).acceleration("tool", "local"),
            B(a=REST).acceleration("tool", "local")),
        "getFrameVelocityDer": lambda: B().frame_derivatives("tool", "local").acceleration_dv.any(),
        "centerOfMass": lambda: close(B().com_dq @ V, B().com_velocity),
        "jacobianCenter": lambda: close(B().com_dq, differences(lambda h: B(bn.integrate(MODEL, Q, h)).com, MODEL.nv),
            1e-5),
        "computeCentroidalMomentum & ccrba": lambda: close(B().centroidal_momentum_dv @ V, B().centroidal_momentum)
            and B().centroidal_momentum_dq.any(),
        "dccrba": absent("dccrba", "momentum_rate", "subtree"),
        "computeKineticEnergy": lambda: close(B().kinetic_energy, 0.5 * V @ C().mass_matrix @ V)
            and B().potential_energy,
        "computeTotalMass": lambda: close(B().mass, MODEL.total_mass),
    },
    "Dynamics": {
        "crba": lambda: close(C().mass_matrix, C().mass_matrix.T),
        "nonLinear & aba": lambda: close(C().mass_matrix @ C().a + C().bias, TAU) and C().da_dv.any(),
        "computeCoriolis": absent("coriolis"),
        "computeGeneralizedGravity": lambda: close(B().gravity_torque, inverse(v=REST, a=REST).tau),
        "rnea(model": lambda: close(inverse(a=C().a).tau, TAU),
        "rnea(..., fext)": lambda: close(inverse(TIP, a=C(TIP).a, force=C(TIP).lambda_).tau, TAU),
        "computeStatic": lambda: close(inverse(TIP, v=REST, a=REST, force=[1.0, 2.0, 3.0]).tau, B().gravity_torque
            - C(TIP).jacobian.T @ [1.0, 2.0, 3.0]),
        "computeRNEA": lambda: inverse().dtau_dq.shape == inverse().dtau_dv.shape == inverse().mass_matrix.shape,
        "computeMinverse": lambda: close(C().da_dtau @ C().mass_matrix, np.eye(MODEL.nv)),
        "computeJointTorqueRegressor": lambda: close(TAU, MODEL.armature * C().a + C().regressor(range(MODEL.nv))
            @ theta()),
    },
    "Contacts": {
        "RigidConstraintModel": lambda: C(SIX.replace(base="world", reference=bn.Reference.centered())).rows == 6,
        "CONTACT_3D": lambda: C(SIX.replace(directions="linear")).rows == 3,
        "initConstraint": lambda: close(C(TIP).jacobian @ C(TIP).da_dtau, np.zeros((3, MODEL.nv)), 1e-6),
        "data.ddq": lambda: close(C(TIP).force("tip").value[:3], C(TIP).lambda_) and C(TIP).a.shape == (MODEL.nv,),
        "computeConstraint": lambda: C(TIP).dlambda_dtau.shape == C(TIP).dlambda_dq.shape == (3, MODEL.nv),
        "impulseDynamics": lambda: close(feet().after.velocity("left_sole_link", "local"), np.zeros(6)),
        "ProximalSettings": lambda: C(TIP, solver=bn.ContactSolver(1e-6, 3, 1e-9)).proximal_iterations <= 3,
    },
    "ReferenceFrame": {
        "LOCAL & WORLD & Reference::surface(R)": lambda: [C(SIX.replace(reference=axes)).lambda_
            for axes in (bn.Reference.local(), bn.Reference.centered(), bn.Reference.world(),
            bn.Reference.surface(np.eye(3)))],
    },
    "The same contact in both": {
        "bodies & default reference": lambda: default(bn.ContactSpec(), base="world",
            reference=bn.Reference.centered()),
        "6D a & 3D a": lambda: {a.name for a in bn.Acceleration} == {"TIME_DERIVATIVE", "SPATIAL", "CLASSICAL"},
        "6D e & 3D e": lambda: default(bn.ContactSpec(), error=bn.PoseError.SPLIT) and bn.PoseError.LOG6,
        "corrector": lambda: close(SIX.with_gains(9.0, 5.0).kp, 9.0 * np.ones(6)),
        "set point": lambda: close(C(SIX.replace(target=B().placement("tool"))).contact_error, np.zeros(6)),
    },
    "State, contacts and dynamics": {
        "StateMultibody": lambda: close(P(r.State()).difference(START, X)[7:], X[7:]),
        "ContactModelMultiple & changeContact": lambda: inactive().rows == 0 and "tip" == C(TIP).contacts[0].name,
        "ContactModel6D": lambda: C(SIX.replace(error=bn.PoseError.LOG6, target=IN_PLACE).with_gains(9.0,
            5.0)).rows == 6,
        "ContactModel3D": lambda: C(SIX.replace(directions="linear", acceleration="classical",
            target=IN_PLACE)).rows == 3,
        "ContactModel1D": lambda: C(SIX.replace(directions="z", acceleration="classical",
            reference=bn.Reference.surface(np.eye(3)))).rows == 1,
        "gains": lambda: close([TIP.kp, TIP.kd], [6 * [9.0], 6 * [5.0]]),
        "DifferentialActionModelContactFwd & JMinvJt": lambda: C(TIP, solver=bn.ContactSolver(1e-6)).a.any(),
        "calcDiff & df_dx": lambda: [C(TIP).da_dq, C(TIP).da_dv, C(TIP).da_dtau, C(TIP).dlambda_dq, C(TIP).dlambda_dv],
        "contacts->Jc": lambda: accelerated().alpha.shape == (3,) and accelerated().dalpha_dq.any(),
        "ActuationModelFloatingBase": lambda: feet().problem.max_controls == TALOS.model.nv - 6,
        "contact->f": lambda: close(C(TIP).force("tip").value[:3], C(TIP).lambda_) and C(TIP).force("tip").text(),
        "DifferentialActionModelFreeFwd": lambda: close(P(r.State()).acceleration(0, X, U), free_arm().a),
        "DifferentialActionModelContactInv & ActuationSquash": absent("inverse_dynamics", "squash", "thruster"),
        "ActuationModelFull": lambda: P(r.State(), actuation=bn.ActuationSpec(["joint_1"])).max_controls == 1,
    },
    "Costs and residuals": {
        "CostModelSum & costs.addCost": lambda: P(bn.CostTerm(r.State(), 2.0, "posture")).term_names(0) == ["posture"]
            and S().problem.term_names(40) == ["goal"],
        "CostModelResidual": lambda: close(cost(r.Control()), cost(r.Control(), penalty=bn.Penalty())),
        "removeCost": lambda: restaged().term_names(0) == ["control"],
        "data.costs": lambda: close(sum(S().problem.term_costs(0, X, U)),
            S().problem.expand(*along(S().problem)).costs[0]) and S().solver.cost_report().terms,
        "ResidualModelState": lambda: close(value(r.State()), P(r.State()).difference(START, X)),
        "ResidualModelControl( & ResidualModelJointEffort": lambda: close(value(r.Control()), U)
            and close(value(r.JointTorque()), U),
        "ResidualModelControlGrav": lambda: close(P(r.Control()).quasi_static("move", START).control,
            K(START).gravity_torque),
        "ResidualModelJointAcc & ResidualModelAbstract": lambda: close(value(r.custom(Acceleration())), free_arm().a),
        "ResidualModelFramePlacement": lambda: close(value(r.FramePlacement("tool", [*POINT, 0, 0, 0, 1])),
            K().placement_error("tool", IN_PLACE)),
        "ResidualModelFrameTranslation": lambda: close(value(r.FramePosition("tool", POINT)), spot("tool") - POINT),
        "ResidualModelFrameRotation": lambda: close(value(r.FrameRotation("tool", [0, 0, 0, 1])),
            K().placement_error("tool", np.eye(4))[3:]),
        "ResidualModelFrameVelocity": lambda: close(value(r.FrameVelocity("tool", bn.Reference.local())),
            K().velocity("tool", "local")),
        "ResidualModelCoM": lambda: close(value(r.CenterOfMass(POINT)), K().com - POINT),
        "ResidualModelCentroidal": lambda: close(value(r.CentroidalMomentum()), K().centroidal_momentum),
        "ResidualModelContactForce": lambda: close(feet().force, feet().f),
        "ResidualModelContactFriction & FrictionCone(...": lambda: close(feet().pyramid,
            np.cos(np.pi / 4) * 0.6 * feet().f[2] - feet().f[[0, 1, 0, 1]] * [1, 1, -1, -1]) and feet().cone[0] > 0.0,
        "ResidualModelContactCoP": lambda: close(feet().pressure[:4], feet().f[2] * np.array([0.1, 0.1, 0.05, 0.05])
            + feet().f[[4, 4, 3, 3]] * [1, -1, 1, -1]),
        "ResidualModelContactWrench": lambda: close(np.sort(feet().pressure[4:]), feet().turns),
        "ResidualModelImpulseCoM": lambda: close(feet().problem.residual(2, 0, feet().landed),
            feet().after.centroidal_momentum),
        "ResidualModelPairCollision": lambda: close(value(r.FrameDistance("tool", reference=bn.Reference("link_3")))[0],
            np.linalg.norm(spot("tool") - spot("link_3"))),
        "ConstraintModelResidual": lambda: close(S().problem.row_lower(0), -0.8 * ONES),
    },
    "Activations": {
        "ActivationModelQuad": lambda: close(cost(r.Control(), penalty=bn.Penalty()), 0.5 * U @ U),
        "ActivationModelWeightedQuad(": lambda: close(cost(r.Control(), weights=U**2), 0.5 * np.sum(U**4)),
        "ActivationModelQuadraticBarrier": lambda: close(cost(r.Control(), penalty=bn.Penalty.barrier([-1.0], [2.0])),
            0.5 + 0.5 * (1.0 + 4.0)),
        "ActivationModelWeightedQuadraticBarrier": lambda: close(cost(r.Control(), weights=3.0 * ONES,
            penalty=bn.Penalty.barrier([-1.0], [2.0])), 9.0),
        "ActivationModelSmooth1Norm": lambda: close(cost(r.Control(), penalty=bn.Penalty.smooth_absolute(0.5)),
            np.sum(np.hypot(U, 0.5) - 0.5)),
        "ActivationModelSmooth2Norm & ActivationModelQuadFlat": lambda: {k.name for k in bn.PenaltyKind} >= {"BARRIER",
            "SMOOTH_ABSOLUTE", "LOG_BARRIER"} and len(bn.PenaltyKind) == 4,
        "ActivationModel2NormBarrier": lambda: close(cost(r.FrameDistance("tool", POINT),
            penalty=bn.Penalty.at_least(2.0)), 0.5 * (2.0 - np.linalg.norm(spot("tool") - POINT)) ** 2),
    },
    "Problems and integrators": {
        "ShootingProblem": lambda: S().problem.knots == 40 and close(S().problem.initial_state, START),
        "IntegratedActionModelEuler": lambda: close(rolled()[7:], X[7:] + STEP * free_arm().a) and close(rolled()[:7],
            X[:7] + STEP * rolled()[7:]),
        "IntegratedActionModelRK": lambda: close(rolled(integrator="runge_kutta4"), rolled(), 5e-2),
        "cost of a node": lambda: close(P(r.Control()).term_costs(0, X, U), [STEP * 0.5 * U @ U]),
        "ControlParametrizationModelPolyZero": lambda: S().solver.us.shape == (40, 7),
        "ControlParametrizationModelPolyOne": absent("polynomial", "poly", "parametrization"),
        "ActionModelImpulse & ImpulseModel": lambda: feet().problem.controls(1) == 0 and bn.ContactSolver(1e-6).mu,
        "IntegratedActionModelAbstract": lambda: close(S().problem.row_upper(1), 0.8 * ONES),
        "model.u_lb": lambda: close(bounded().control_lower(0), -ONES) and close(bounded().control_upper(0), ONES),
        "problem.calc(": lambda: bounded().expand(*along(bounded())).cost == bounded().evaluate(*along(bounded())).cost,
        "problem.rollout": lambda: rolled().shape == (14,),
        "problem.quasiStatic": lambda: feet().still.residual < 1e-6 and close(feet().problem.quasi_static("stand",
            feet().x, [np.nan] * 2 + [400.0] + [np.nan] * 9).force[2], 400.0),
        "problem.x0": lambda: runs(bounded().set_initial_state, X),
        "problem.circular": lambda: runs(bounded().advance, "move"),
        "problem.updateModel": lambda: restaged().term_names(0) == ["control"] and runs(P(r.Control()).set_target, 0,
            "control", U),
        "problem.nthreads": lambda: solve(S().problem, threads=2).feasible,
        "DifferentialActionModelNumDiff": lambda: bn.check_problem(P(r.State(), r.Control())).pass_,
    },
    "Solvers": {
        "SolverFDDP": lambda: bn.DdpOptions().update is bn.StepUpdate.ROLLOUT and solve(S().problem,
            update="multiple_shooting").reason is DONE,
        "SolverDDP": lambda: len(bn.StepUpdate) == 2,
        "SolverBoxFDDP": lambda: solve(bounded()).feasible,
        "SolverIntro": absent("ipopt", "kkt", "nullspace"),
        "solver.solve( & maxiter & regularization starts": lambda: S().summary.reason is DONE
            and default(bn.DdpOptions(), max_iterations=100),
        "setCandidate": lambda: guessed().xs.shape == (41, 14) and guessed().solve().iterations <= 2,
        "solver.xs": lambda: S().solver.xs.shape == (41, 14) and S().solver.us.shape == (40, 7),
        "solver.K": lambda: answered() and abs(S().solver.feedforward(0)).max() < 1e-2 and S().solver.named_gain(0),
        "solver.Vx": lambda: S().solver.value_gradient(0).any() and S().solver.value_hessian(0).any(),
        "solver.th_stop & th_gapTol": lambda: default(bn.DdpOptions(), stop_tolerance=1e-9, gap_tolerance=1e-9),
        "stoppingCriteria": lambda: S().summary.expected_improvement < 1e-9 and S().solver.optimality_error() < 1e-3,
        "th_acceptStep & alphas": lambda: default(bn.LineSearch(), sufficient_decrease=0.1, allowed_increase=2.0,
            halvings=9),
        "reg_incFactor & th_stepDec": lambda: default(bn.Regularization(), factor=10.0, smallest=1e-9, largest=1e9,
            decrease_above=0.5, increase_at_or_below=0.01),
        "solver.setCallbacks": lambda: solve(P(r.State(), r.Control()),
            callback=lambda progress: False).reason is bn.StopReason.CALLBACK and S().seen,
        "CallbackLogger & solver.iter": lambda: len(S().summary.log) == S().summary.iterations == len(S().seen)
            and S().summary.feasible and S().summary.violation < 1e-6,
        "plotSolution": lambda: callable(bn.plot.solution),
    },
    "MuJoCo": {
        "mj_loadXML": lambda: floating().nv == 6 + 1,
        "mj_fullM & qfrc_bias & mj_forward": lambda: close(C().mass_matrix @ C().a + C().bias, TAU),
        "qfrc_passive": lambda: abs(B().passive_torque).max() > 0.0,
        "mj_inverse": lambda: close(inverse(TIP, a=C(TIP).a, force=C(TIP).lambda_).tau, TAU),
        "mjd_transitionFD": lambda: C().da_dq.any(),
        "mj_integratePos": lambda: close(bn.difference(MODEL, Q, bn.integrate(MODEL, Q, V)), V),
        "mj_jac": lambda: B().frame_derivatives("tool", "centered").jacobian.any(),
        "mj_contactForce & cvel & contacts found": lambda: C(TIP).force("tip").reference == TIP.reference,
        "solref": lambda: default(TIP.with_gains(2.0, 1.0), friction=None) and bn.ContactSolver(1e-6).mu == 1e-6,
        "quaternion": lambda: close(order().q_from([0, 0, 0, 1, 0, 0, 0, 0.5]), [0, 0, 0, 0, 0, 0, 1, 0.5]),
        "velocity": lambda: close(order().v_from(range(1, 8), TURNED), [2, -1, 3, 4, 5, 6, 7]),
        "acceleration": lambda: close(*free_joint_rates()),
        "force & mass matrix & bias": lambda: close(order().tau_from(range(1, 8), TURNED), [2, -1, 3, 4, 5, 6, 7]),
    },
    "MuJoCo MPC": {
        "Task & Agent(": lambda: control().controller.spec.schedule == control().spec.schedule,
        "ResidualFn & <user": lambda: bn.CostTerm(r.State(), 2.0, "posture", penalty=bn.Penalty()).weight == 2.0,
        "kQuadratic": lambda: close(cost(r.Control()), 0.5 * U @ U),
        "kSmoothAbsLoss": lambda: close(cost(r.Control(), penalty=bn.Penalty.smooth_absolute(2.0)), np.sum(np.hypot(U,
            2.0) - 2.0)),
        "kL2": lambda: cost(r.FrameDistance("tool", POINT), penalty=bn.Penalty.smooth_absolute(0.1)),
        "kCosh & kRectify & kNull": lambda: len(bn.PenaltyKind) == 4 and cost(r.Control(),
            penalty=bn.Penalty.at_least(3.0)),
        "task_risk & sampling planners & GUI": absent("risk", "cross_entropy", "predictive_sampling", "gui"),
        "agent_horizon & agent_integrator": lambda: close(growing().time_of(5), 0.1) and bn.Stage().integrator,
        "total return": lambda: close(P(r.Control()).evaluate(*along(bounded())).cost, 3 * STEP * 0.5 * U @ U),
        "residual_": lambda: runs(P(r.Control()).set_target, 0, "control", U) and value(r.FramePosition("tool",
            lambda t: POINT)).any(),
        "set_cost_weights": lambda: absent("set_weight")() and restaged().term_names(0) == ["control"],
        "TransitionLocked": lambda: control().controller.schedule.phases[1].name == "b"
            and control().command.phase == 1,
        "agent_planner & ilqg_": lambda: control().spec.solver.update and default(control().spec.solver,
            line_search=bn.LineSearch(), regularization=bn.Regularization()),
        "derivatives": lambda: bn.check_problem(P(r.FramePosition("tool", POINT))).pass_,
        "control limits": lambda: close(bounded().control_upper(0), ONES) and len(control().spec.torque_limit) == 0,
        "limits of states": lambda: len(S().problem.row_names(0)) == 7,
        "agent.set_state & agent.planner_step": lambda: np.shape(ticked().tau) == (7,),
        "planning in a thread": lambda: bn.PlanTiming.THREAD and control().spec.timing is bn.PlanTiming.FIXED,
        "get_action(": lambda: control().spec.feedback and not control().spec.replace(feedback=False).feedback,
        "iLQG policy": lambda: control().controller.feedback().gain.shape == (7, 14),
        "agent.best": lambda: control().controller.plan().shape == (11, 14),
        "agent.get_cost": lambda: set(control().controller.plan_costs(0)) == {"state", "control"},
        "agent.reset": lambda: runs(bn.MpcController(control().spec).reset),
        "agent.step": lambda: bn.has_mujoco() in (True, False) and len(control().loop.trace) > 10,
        "estimators": lambda: callable(bn.BaseEstimator) and control().spec.model_error,
    },
    "Model, cost and horizon": {
        "AcadosOcp & ocp.model.x & ocp.model.f_expl": lambda: S().problem.nx == 14 and slow().nx == 21,
        "ocp.model.f_impl & EXTERNAL": absent("implicit_dynamics", "algebraic", "external_cost"),
        "ocp.model.p": lambda: runs(bn.Problem(S().problem.spec).set_payload, "tool", bn.InertiaSpec())
            and callable(bn.Problem.set_friction) and callable(bn.Problem.set_surface)
            and runs(P(r.Control(), inputs=[bn.InputSpec("mu", value=0.5)]).set_input, "mu", 0.6),
        "cost.cost_type = LINEAR": lambda: close(value(r.JointPosition()), X[:7]) and close(value(r.JointVelocity()),
            X[7:]) and close(value(r.State()), X - START),
        "cost.cost_type = NONLINEAR": lambda: value(r.custom(Acceleration())).shape == (7,),
        "CONVEX": lambda: cost(r.Control(), penalty=bn.Penalty.log_barrier([-9.0], [9.0], 0.1)),
        "cost.W & costs times": lambda: close(cost(r.Control(), 3.0, weights=2.0 * ONES), 3.0 * U @ U),
        "cost.yref": lambda: close(value(r.Control(2.0 * U)), -U),
        "cost.W_e": lambda: S().problem.term_costs(40, X)[0] > 0.0,
        "solver_options.N_horizon & time_steps": lambda: growing().step_of(4) > 0.02 and runs(bounded().set_step, 0,
            0.02),
        "AcadosMultiphaseOcp": lambda: feet().problem.stage_of(0) != feet().problem.stage_of(1),
        "integrator_type": lambda: default(bn.Stage(), integrator=bn.Integrator.SEMI_IMPLICIT_EULER),
        "IRK": lambda: len(bn.Integrator) == 2 and bn.check_steps(S().problem, S().solver.xs, S().solver.us),
    },
    "Constraints": {
        "constraints.x0": lambda: runs(bounded().set_initial_state, X),
        "lbu": lambda: close(bounded().control_lower(0), -ONES),
        "lbx": lambda: close(P(bn.Constraint(r.JointPosition(), lower=-1.0)).row_lower(0), -ONES),
        "lg": lambda: close(P(bn.Constraint(r.custom(Acceleration()), "limit", upper=1.0, scale=1.0)).row_upper(0),
            ONES),
        "lh, uh": lambda: outside().start_violations[0].upper == 0.5,
        "lh_e": lambda: P(terminal_constraints=[bn.Constraint(r.JointVelocity(), "rest", 0, 0)]).row_names(3),
        "lphi": lambda: bn.LimitOptions().curvature,
        "idxsh": lambda: np.isinf(bn.Constraint(r.Control()).l1_weight) and soft(1e-3) > 0.1,
        "cost.zl": lambda: close([soft(0.5 * STEP), soft(3.0 * STEP)], [1.5, 0.0], 1e-4),
        "cost.Zl & slack costs": lambda: close(soft(0.5 * STEP, 2.0 * STEP), 0.5, 1e-4),
        "lsh": absent("slack", "idxs"),
        "tolerances": lambda: close(S().solver.cost_report().rows[0].scale, 0.8),
    },
    "Solver": {
        "nlp_solver_type = SQP": lambda: solve(S().problem, update="multiple_shooting").feasible,
        "nlp_solver_type = DDP": lambda: solve(S().problem, update="rollout").feasible,
        "nlp_solver_type = SQP_RTI": lambda: solve(S().problem, max_iterations=1).iterations == 1
            and control().spec.solver.max_iterations == 1,
        "rti_phase & as_rti & hpipm_mode": absent("rti", "condensing", "hpipm", "preparation"),
        "qp_solver =": lambda: S().summary.log[0].factorizations > 0,
        "qp_solver_iter_max": lambda: default(bn.LimitOptions(), max_factorizations=50, max_sweeps=100),
        "hessian_approx & globalization & levenberg": lambda: default(bn.DdpOptions(), limits=bn.LimitOptions(),
            line_search=bn.LineSearch(), regularization=bn.Regularization()) and bn.LimitOptions().curvature,
        "nlp_solver_max_iter": lambda: default(bn.DdpOptions(), max_iterations=100, time_budget=np.inf)
            and runs(guessed().set_time_budget, 0.0),
        "nlp_solver_tol": lambda: default(bn.DdpOptions(), stop_tolerance=1e-9, gap_tolerance=1e-9)
            and guessed().options.limits.tolerance == 1e-8 and S().solver.optimality_error() < 1e-3,
        "solver.solve(": lambda: S().summary.reason is DONE and S().solver.text(),
        'solver.solve_for_x0 & solver.get(i, "x")': lambda: close(S().solver.xs[0], START) and S().solver.us.any(),
        'solver.get(i, "lam")': lambda: multiplier(-3.0) < 0.0 < multiplier(3.0),
        'solver.get(i, "sl")': lambda: S().solver.cost_report().limits[0].value and S().solver.cost_report().rows,
        "solver.get_cost": lambda: S().summary.largest_gap < 1e-9 and S().summary.seconds.total > 0.0,
        "get_from_qp_in & eval_solution": lambda: answered() and S().solver.value_hessian(1).shape == (14, 14),
        "eval_and_get": lambda: close(slope(), S().solver.value_gradient(0)[3], 1e-3),
        "sensitivities by": absent("p_global", "cost_by_payload"),
        "solver.set(i, & warm start & store_iterate": lambda: guessed().solve().iterations <= 2
            and runs(guessed().shift_limits, 1),
        "solver.reset": lambda: runs(guessed().forget_limits),
        "AcadosOcpSolver.generate & AcadosOcpBatch": absent("generate_code", "codegen", "batch_solver", "ddpbatch"),
        "AcadosSimSolver": lambda: rolled().shape == (14,) and control().loop.plant.time > 0.0,
    },
    "What differs from all or some of them": {
        "joint order": lambda: all(names == sorted(names) for names in siblings(TALOS.model)),
        "continuous joint": lambda: close(bn.difference(wheel("continuous"), [1, 0], [0, -1]), [-np.pi / 2]),
        "planar joint": lambda: wheel("planar").nq == 4 and wheel("planar").nv == 3,
        "ball joint & quaternion": lambda: close(bn.load_robot("talos").model.q_neutral[3:7], [0, 0, 0, 1]),
        "joint axis": lambda: [j.placement for j in TALOS.model.joints],
        "free-flyer velocity & spatial vectors": lambda: close(B(feet().x[:37], np.arange(36.0), None,
            TALOS.model).velocity("base_link", "local"), np.arange(6.0)),
        "d/dq": lambda: C().da_dq.shape == (MODEL.nv, MODEL.nv) and feet().problem.ndx == 2 * TALOS.model.nv,
        "lambda": lambda: feet().still.force[2] > 0.0 and close(C(TIP).mass_matrix @ C(TIP).a + C(TIP).bias, TAU
            + C(TIP).jacobian.T @ C(TIP).lambda_),
        "wrench of": lambda: C(TIP).wrench("tip", bn.Reference.world()).shape == (6,),
        "directions": lambda: [C(SIX.replace(directions=d)).rows for d in ("z,rx", "all", "x")] == [2, 6, 1],
        "acceleration & error & target": lambda: default(bn.ContactSpec(), error=bn.PoseError.SPLIT,
            acceleration=bn.Acceleration.TIME_DERIVATIVE) and close(bn.ContactSpec().target, np.eye(4)),
        "armature": lambda: close(inverse(v=REST, a=A).tau - inverse(v=REST, a=REST).tau, C().mass_matrix @ A),
        "damping": lambda: MODEL.damping.any() and not P(r.State()).spec.actuation.passive_torques,
        "effort, vel": lambda: (MODEL.effort_limit > 0.0).all() and (MODEL.velocity_limit > 0.0).all(),
        "locked": lambda: "arm_left_1_joint" in MODEL.locked_joints and MODEL.has_frame("arm_left_1_link"),
        "mimic": lambda: any(f.follows for f in bn.load_robot("gripper").model.joints)
            or bn.load_robot("gripper").model.loops,
        "links without": lambda: "joint 'j'" in refusal(
            lambda: bn.ContactDynamics(wheel("continuous", 0.0)).forward([1, 0], [0], [0])),
        "matrices": lambda: C().da_dq.flags.c_contiguous,
        "redundant": lambda: bn.diagnose(MODEL, [SIX, SIX.replace(name="again")], Q).redundant
            and bn.ContactDynamics(MODEL, [SIX, SIX.replace(name="again")], bn.ContactSolver(1e-6)).forward(Q, V,
            TAU) is bn.Status.OK,
        "bad input": lambda: refusal(lambda: C().forward(np.nan * Q, V, TAU)),
        "gravity": lambda: close(MODEL.gravity, [0, 0, -9.81]),
    },
}


STARTS = {section: {start: check for key, check in checks.items() for start in key.split(" & ")}
          for section, checks in CHECKS.items()}


def start_of(row: Row) -> str:
    """Returns the longest start in CHECKS with which the row begins."""
    text = row.theirs or row.ours.replace("`", "")
    return max((start for start in STARTS.get(row.section, {}) if text.startswith(start)), key=len, default="")


ROWS = rows_of_page()


@pytest.mark.parametrize("row", ROWS, ids=[f"{row.section}: {row.theirs[:40]}" for row in ROWS])
def test_row_of_the_page_runs_on_a_robot(row: Row) -> None:
    start = start_of(row)
    assert start, f"CHECKS[{row.section!r}] has no entry for {row.theirs!r}"
    assert STARTS[row.section][start]()


def test_every_check_has_a_row() -> None:
    for section, checks in CHECKS.items():
        used = [start_of(row) for row in ROWS if row.section == section]
        assert sorted(set(used)) == sorted(start for key in checks for start in key.split(" & ")), section


def test_every_name_in_the_cells_exists() -> None:
    if not (ROOT / "include").is_dir():
        pytest.skip("the sources are not here")
    words = {word for header in (ROOT / "include").rglob("*.hpp") for word in re.findall(r"\w+", header.read_text())}
    found = {row.theirs: unknown_names(row, NAMES | words | set(OBJECTS)) for row in ROWS}
    assert not {theirs: names for theirs, names in found.items() if names}
