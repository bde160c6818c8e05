"""Contact dynamics of many states at once."""

from __future__ import annotations

import gc
import threading
import time
import tracemalloc
from typing import List

import numpy as np
import pytest

import burnish
from burnish import ContactDynamics, ContactDynamicsBatch, ContactSpec, Status
from dynamics_cases import MODEL, PAD, SOLES, TALOS, TIP, Array, assert_close, states


class TestBatches:
    N = 45  # not a multiple of any pack width

    @pytest.mark.parametrize("model, contacts", [(MODEL, [TIP]), (TALOS.model, SOLES), (MODEL, [])])
    @pytest.mark.parametrize("threads", [1, 2])
    def test_batch_matches_single_states(self, model: burnish.Model,
                                               contacts: List[ContactSpec], threads: int) -> None:
        single = ContactDynamics(model, contacts)
        batch = ContactDynamicsBatch(model, contacts, capacity=self.N + 3, threads=threads)
        assert (batch.rows, batch.capacity, batch.threads) == (single.rows, self.N + 3, threads)
        q, v, tau = states(model, self.N)
        assert batch.forward_with_derivatives(q, v, tau) is Status.OK
        assert batch.status is Status.OK
        assert batch.statuses.dtype == np.uint8 and not batch.statuses.any()
        names = ["a", "lambda_", "da_dq", "da_dv", "da_dtau", "dlambda_dq", "dlambda_dv",
                 "dlambda_dtau"]
        results = {name: getattr(batch, name) for name in names}
        for i in range(self.N):
            single.forward(q[i], v[i], tau[i])
            single.forward_derivatives()
            for name in names:
                wanted = getattr(single, name)
                assert results[name].shape == (self.N, *wanted.shape)
                if wanted.size:
                    assert_close(results[name][i], wanted, 1e-9)
        forward_only = ContactDynamicsBatch(model, contacts, self.N)
        forward_only.forward(q, v, tau)
        np.testing.assert_array_equal(forward_only.a, results["a"])

    def test_smaller_batch_after_a_larger_one_is_correct(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 10)
        batch.forward_with_derivatives(q, v, tau)
        a, da_dq = batch.a.copy(), batch.da_dq.copy()
        batch.forward_with_derivatives(q[3:4], v[3:4], tau[3:4])
        assert batch.a.shape == (1, MODEL.nv) and batch.da_dq.shape == (1, MODEL.nv, MODEL.nv)
        np.testing.assert_allclose(batch.a, a[3:4], rtol=1e-12)
        np.testing.assert_allclose(batch.da_dq, da_dq[3:4], rtol=1e-9, atol=1e-9)

    def test_results_are_read_only_views_that_outlive_the_batch(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 10)
        batch.forward_with_derivatives(q, v, tau)
        a, dlambda_dq = batch.a, batch.dlambda_dq
        assert np.shares_memory(a, batch.a)
        for view in (a, dlambda_dq):
            with pytest.raises(ValueError):
                view[0] = 1.0
        batch.forward(q, v, 2.0 * tau)
        doubled = batch.a.copy()
        np.testing.assert_array_equal(a, doubled)  # overwritten, as documented
        del batch
        gc.collect()
        np.testing.assert_array_equal(a, doubled)
        assert np.isfinite(dlambda_dq).all()

    def test_float64_rows_are_read_without_a_copy(self) -> None:
        n = 4000
        batch = ContactDynamicsBatch(MODEL, [], n)
        arguments = states(MODEL, n)

        def allocated(*given: Array) -> int:
            tracemalloc.start()
            batch.forward(*given)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            return peak

        assert allocated(*arguments) < 8 * n
        assert allocated(*(x[:, :].astype(np.float32) for x in arguments)) > 8 * n * MODEL.nq
        batch.forward(*arguments)
        a = batch.a.copy()
        batch.forward(*(np.asfortranarray(x) for x in arguments))
        np.testing.assert_array_equal(batch.a, a)

    def test_failed_state_is_flagged_and_leaves_the_others(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 20)
        q, v, tau = states(MODEL, 20)
        batch.forward(q, v, tau)
        wanted = batch.a.copy()
        v[7, 2] = np.nan
        assert batch.forward(q, v, tau) is Status.NOT_FINITE
        assert batch.status is Status.NOT_FINITE
        assert list(np.flatnonzero(batch.statuses)) == [7]
        assert Status(batch.statuses[7]) is Status.NOT_FINITE
        assert not batch.a[7].any()
        others = np.arange(20) != 7
        np.testing.assert_array_equal(batch.a[others], wanted[others])

    def test_arguments_of_wrong_shape_raise_with_their_name(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP], 10)
        q, v, tau = states(MODEL, 11)
        for given, sentence in [
            ((q[:5, 1:], v[:5], tau[:5]), "q is 5 x 5; wanted 5 x 6, one row per state"),
            ((q[:5], v[:4], tau[:5]), "v is 4 x 6; wanted 5 x 6, one row per state"),
            ((q[:5], v[:5], tau[:5].T), "tau is 6 x 5; wanted 5 x 6, one row per state"),
            ((q, v, tau), "there are 11 states; wanted 1 to 10, the capacity"),
            ((q[:0], v[:0], tau[:0]), "there are 0 states; wanted 1 to 10, the capacity"),
        ]:
            with pytest.raises(burnish.Error, match="^ContactDynamicsBatch.forward: " + sentence):
                batch.forward(*given)
        for bad in ({"capacity": 0}, {"capacity": 5, "threads": 0},
                    {"capacity": 5, "threads": 2000, "pin_threads": True}):
            with pytest.raises(burnish.Error):
                ContactDynamicsBatch(MODEL, [TIP], **bad)

    def test_results_of_an_earlier_call_raise(self) -> None:
        batch = ContactDynamicsBatch(MODEL, [TIP, PAD], 10)
        with pytest.raises(burnish.EvaluationError, match="ContactDynamicsBatch.a: this is a result of"):
            batch.a
        batch.forward(*states(MODEL, 10))
        with pytest.raises(burnish.EvaluationError, match="forward_with_derivatives"):
            batch.da_dq
        batch.set_active("tip", False)
        with pytest.raises(burnish.EvaluationError):
            batch.lambda_
        batch.forward_with_derivatives(*states(MODEL, 10))
        assert batch.lambda_.shape == (10, 1) and batch.dlambda_dq.shape == (10, 1, MODEL.nv)

    def test_batch_in_use_by_a_thread_refuses_another(self) -> None:
        n = 20000
        batch = ContactDynamicsBatch(MODEL, [TIP], n)
        arguments = states(MODEL, n)
        stop = threading.Event()

        def work() -> None:
            while not stop.is_set():
                batch.forward_with_derivatives(*arguments)

        batch.forward_with_derivatives(*arguments)
        wanted = batch.a.copy()
        thread = threading.Thread(target=work)
        thread.start()
        refused = ""
        end = time.monotonic() + 60.0
        try:
            while not refused and time.monotonic() < end:
                try:
                    batch.a
                except burnish.Error as error:
                    refused = str(error)
        finally:
            stop.set()
            thread.join()
        assert "in use by another thread" in refused
        np.testing.assert_array_equal(batch.a, wanted)

    def test_pack_width_is_a_power_of_two(self) -> None:
        assert burnish.pack_width() in (1, 2, 4, 8)
