"""calibrate and Calibration."""
import json, os, signal, threading, unittest
import numpy as np
import mesopix, samples

FAST = {"loading.velocity": 0.3, "output.history_rows": 100}


class Calibrate(unittest.TestCase):
    def test_meets_a_peak(self):
        trials = []
        fit = mesopix.calibrate(samples.specimen(), FAST, peak_stress=2e6, seeds=2, progress=trials.append)
        self.assertTrue(fit.met, fit.why_not_met)
        self.assertLess(fit.misfit, 0.02)
        self.assertEqual(set(fit.settings), {"phases.mortar.tensile_scale", "phases.itz.tensile_scale"})
        peaks = [curve.stress.max() for curve in fit.curves]
        self.assertEqual(len(peaks), 2)
        self.assertAlmostEqual(np.mean(peaks), 2e6, delta=0.02 * 2e6)
        self.assertEqual([trial.number for trial in trials], list(range(1, len(trials) + 1)))
        self.assertEqual(min(trial.misfit for trial in trials), trials[-1].best_misfit)
        self.assertEqual(fit.summary["evaluations"], len(trials))
        self.assertRegex(repr(fit), "^<mesopix.Calibration to a peak of 2 MPa: misfit .* %; phases.mortar.tensile_scale = ")

    def test_what_was_fitted_breaks_as_it_says(self):
        fit = mesopix.calibrate(samples.specimen(), FAST, peak_stress="2 MPa", seeds=1)
        again = mesopix.simulate(samples.specimen(), {**FAST, **fit.settings})
        self.assertAlmostEqual(again.peak_stress, fit.curves[0].stress.max(), delta=1)

    def test_meets_a_curve_that_is_an_array(self):
        wanted = samples.run(**{"mortar.tensile_scale": 10e6, "itz.tensile_scale": 6e6, "stop_strain": 1.5e-4}).curve
        fit = mesopix.calibrate(
            samples.specimen(), {"loading.velocity": 0.2}, target=wanted, free=["tensile_scale"], seeds=1,
            max_evaluations=30)
        factor = fit.summary["parameters"][0]["factor"]
        self.assertAlmostEqual(factor, 10 / 15, delta=0.05)

    def test_saves_a_folder_that_simulates(self):
        with samples.empty_folder():
            fit = mesopix.calibrate(samples.specimen(), FAST, peak_stress=2e6, seeds=1, max_evaluations=3)
            fit.save("fit")
            with open("fit/calibration.json") as figures:
                self.assertEqual(json.load(figures), fit.summary)
            self.assertTrue(os.path.exists("fit/report.html"))
            self.assertAlmostEqual(
                mesopix.simulate("fit/scene.toml").peak_stress, fit.curves[0].stress.max(), delta=1)

    def test_curves_are_views(self):
        fit = mesopix.calibrate(samples.specimen(), FAST, peak_stress=2e6, seeds=1, max_evaluations=2)
        self.assertTrue(np.shares_memory(fit.curves[0].stress, fit.curves[0].stress))
        stress = fit.curves[0].stress
        copy = stress.copy()
        del fit
        np.testing.assert_array_equal(stress, copy)

    def test_ends_where_progress_stops_the_iteration_with_the_best(self):
        def progress(trial):
            if trial.number == 2:
                raise StopIteration

        fit = mesopix.calibrate(samples.specimen(), FAST, peak_stress="0.5 MPa", seeds=1, progress=progress)
        self.assertEqual(fit.summary["evaluations"], 2)

    def test_raises_again_what_progress_raises(self):
        with self.assertRaises(ZeroDivisionError):
            mesopix.calibrate(samples.specimen(), FAST, peak_stress=2e6, seeds=1, progress=lambda trial: 1 / 0)

    def test_ctrl_c_keeps_the_best(self):
        def press(trial):
            if trial.number == 2:
                threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()

        with self.assertRaises(mesopix.Interrupted) as raised:
            mesopix.calibrate(
                samples.specimen(), {"loading.velocity": 0.002}, peak_stress="0.5 MPa", seeds=2, progress=press)
        self.assertGreaterEqual(raised.exception.result.summary["evaluations"], 2)

    def test_says_what_it_lacks(self):
        with self.assertRaisesRegex(mesopix.Error, "no target is given; a target is peak_stress, peak_strain or both"):
            mesopix.calibrate(samples.specimen())
        with self.assertRaisesRegex(mesopix.Error, "^seeds: 0; must lie in"):
            mesopix.calibrate(samples.specimen(), peak_stress=2e6, seeds=0)
        with self.assertRaisesRegex(mesopix.Error, "target: 2 strains and 1 stresses; must be as many"):
            mesopix.calibrate(samples.specimen(), target=([0, 1e-4], [0]))


if __name__ == "__main__":
    unittest.main()
