"""study and Study."""
import os, signal, threading, unittest, warnings
import h5py
import numpy as np
import mesopix, samples

FAST = {"loading.velocity": 0.3, "loading.stop_drop": 0.3, "output.history_rows": 100}


class Study(unittest.TestCase):
    def setUp(self):
        folder = samples.empty_folder()
        folder.__enter__()
        self.addCleanup(folder.__exit__, None, None, None)

    def test_breaks_a_specimen_with_many_seeds(self):
        told = []
        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=3, progress=told.append)
        self.assertEqual((len(study), study.failures), (3, {}))
        self.assertEqual([(p.done, p.failed, p.before, p.all) for p in told], [(i, 0, 0, 3) for i in (1, 2, 3)])
        self.assertEqual(list(study.table["seed"]), [1, 2, 3])
        self.assertEqual(study.units["peak_stress"], "Pa")
        single = mesopix.simulate(samples.specimen(), FAST, seed=2, threads=1)
        self.assertEqual(study.table["peak_stress"][1], single.peak_stress)
        self.assertAlmostEqual(study.curves[1].stress.max(), single.peak_stress)
        self.assertEqual(study.crack_counts.shape, samples.specimen().labels.shape)
        self.assertGreater(study.crack_counts.max(), 1)
        self.assertTrue(os.path.exists("study/report.html"))
        self.assertRegex(repr(study), "^<mesopix.Study: 3 of 3 members done; in study>$")
        peaks = study.table["peak_stress"]
        expected = 4.303 * peaks.std(ddof=1) / np.sqrt(3) / peaks.mean()  # Student's t for two degrees of freedom
        self.assertAlmostEqual(study.half_width, expected, delta=1e-3 * expected)

    def test_goes_on_where_it_was_and_grows(self):
        mesopix.study(samples.specimen(), FAST, output="study", seeds=2)
        told = []
        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=3, progress=told.append)
        self.assertEqual([(p.done, p.before) for p in told], [(1, 2)])
        self.assertEqual(len(study), 3)

    def test_varies_settings_by_their_names_in_si_units(self):
        study = mesopix.study(
            samples.specimen(), FAST, output="study",
            vary={"velocity": [0.2, "0.4 m/s"], "mortar.tensile_scale + itz.tensile_scale": {"from": 8e6, "to": 10e6, "steps": 2}})
        self.assertEqual(list(study.table["loading.velocity"]), [0.2, 0.2, 0.4, 0.4])
        strengths = study.table["phases.mortar.tensile_scale + phases.itz.tensile_scale"]
        np.testing.assert_allclose(strengths, [8e6, 10e6] * 2)
        self.assertLess(study.table["peak_stress"][0], study.table["peak_stress"][1])

    def test_samples_a_range(self):
        study = mesopix.study(samples.specimen(), FAST, output="study", sampling="sobol", samples=2,
                              vary={"mortar.young": {"low": 20e9, "high": 30e9}})
        self.assertTrue(np.all((study.table["phases.mortar.young"] > 20e9) & (study.table["phases.mortar.young"] < 30e9)))

    def test_keeps_a_study_that_the_program_goes_on_with(self):
        mesopix.study(samples.specimen(), FAST, output="study", seeds=2)
        told = []
        again = mesopix.study("study/study.toml", output="study", progress=told.append)
        self.assertEqual((told, len(again)), ([], 2))

    def test_takes_a_study_file_and_nothing_beside_it(self):
        scene = mesopix.simulate(samples.specimen(), FAST).scene
        samples.specimen().write("specimen.h5")
        with open("scene.toml", "w") as file:
            file.write(scene)
        with open("two.toml", "w") as file:
            file.write('scene = "scene.toml"\nseeds = 2\n')
        self.assertEqual(len(mesopix.study("two.toml", output="two")), 2)
        with self.assertRaisesRegex(mesopix.Error, "^seeds: 3; given beside a study file; write it there"):
            mesopix.study("two.toml", output="three", seeds=3)
        with self.assertRaisesRegex(mesopix.Error, "^velocity: 0.1; given beside a study file"):
            mesopix.study("two.toml", output="three", velocity=0.1)

    def test_tells_what_a_long_study_takes_before_it(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(mesopix.LongRun, "^2 members of up to [0-9]+ points and .* 1 at a time$"):
                mesopix.study(samples.specimen(), output="study", seeds=2, jobs=1, velocity=1e-6)

    def test_has_no_peak_of_members_that_reached_none(self):
        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=2, vary={"loading.stop_strain": [2e-5, 3e-4]})
        self.assertEqual(list(np.isnan(study.table["peak_stress"])), [True, False, True, False])
        self.assertEqual(list(study.table["peak_reached"]), [0, 1, 0, 1])

    def test_takes_as_many_seeds_as_the_mean_needs(self):
        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=2, until_ci="20 %")
        self.assertGreaterEqual(len(study), 10)
        self.assertLessEqual(study.half_width, 0.2)

    def test_keeps_failures_and_runs_them_again(self):
        with open("scene.toml", "w") as file:
            file.write('[generate]\nwidth = "16 mm"\nheight = "16 mm"\npixel_size = "1 mm"\nfraction = 0.3\n'
                       'd_min = "4 mm"\nd_max = "8 mm"\n')
        wanted = dict(output="study", vary={"generate.fraction": [0.3, 0.89]})
        study = mesopix.study("scene.toml", FAST, **wanted)
        self.assertEqual(list(study.table["state"]), ["done", "failed"])
        self.assertRegex(study.failures[1], "generate.fraction")
        self.assertTrue(np.isnan(study.table["peak_stress"][1]))
        self.assertRegex(repr(study), "1 of 2 members done, 1 failed")
        told = []
        mesopix.study("scene.toml", FAST, **wanted, progress=told.append)
        self.assertEqual(told, [])
        mesopix.study("scene.toml", FAST, **wanted, retry=True, progress=told.append)
        self.assertEqual([(p.failed, p.before) for p in told], [(1, 1)])

    def test_ends_where_progress_stops_the_iteration(self):
        def progress(p):
            raise StopIteration

        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=5, jobs=1, progress=progress)
        self.assertEqual(list(study.table["state"]).count("done"), 1)
        self.assertIsNone(study.curves[4])
        self.assertFalse(os.path.exists("study/table.csv"))
        self.assertEqual(len(mesopix.study(samples.specimen(), FAST, output="study", seeds=5).table["member"]), 5)

    def test_ctrl_c_keeps_what_is_done(self):
        def press(p):
            if p.done == 1:
                threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()

        with self.assertRaisesRegex(mesopix.Interrupted, "^interrupted; .* of 1000 members are done") as raised:
            mesopix.study(samples.specimen(), FAST, output="study", seeds=1000, progress=press)
        self.assertGreaterEqual(list(raised.exception.result.table["state"]).count("done"), 1)

    def test_raises_again_what_progress_raises(self):
        with self.assertRaises(ZeroDivisionError):
            mesopix.study(samples.specimen(), FAST, output="study", seeds=2, progress=lambda p: 1 / 0)

    def test_runs_beside_others_that_read_files(self):
        samples.specimen().write("specimen.h5")
        thread = threading.Thread(target=mesopix.study, args=(samples.specimen(), FAST),
                                  kwargs={"output": "study", "seeds": 8})
        thread.start()
        while thread.is_alive():
            self.assertEqual(mesopix.read_specimen("specimen.h5").labels.shape, (60, 60))
        thread.join()
        self.assertEqual(len(os.listdir("study/members")), 8)

    def test_says_what_is_wrong_and_leaves_nothing(self):
        for message, wanted in {
            "^seeds: nothing varies": {},
            "^vary.speed: .*unknown option|^speed: unknown option": {"vary": {"speed": [1]}},
            "^vary.velocity: 0.1; must be a sequence of values": {"vary": {"velocity": 0.1}},
            r"^vary.loading.velocity: .*-1 m/s.*: must be > 0": {"vary": {"velocity": [-1]}},
            "^seeds: .*must lie in": {"seeds": 0},
            "^jobs: 0; must lie in": {"seeds": 2, "jobs": 0},
            "^until_ci: 0.1; needs a study with seeds": {"vary": {"velocity": [0.1, 0.2]}, "until_ci": 0.1},
        }.items():
            with self.assertRaisesRegex(mesopix.Error, message):
                mesopix.study(samples.specimen(), FAST, output="study", **wanted)
            self.assertFalse(os.path.exists("study"), message)

    def test_refuses_the_folder_of_another_study(self):
        mesopix.study(samples.specimen(), FAST, output="study", seeds=2)
        with self.assertRaisesRegex(mesopix.Error, "^output: study; holds another specimen; choose another folder"):
            mesopix.study(samples.specimen(seed=4), FAST, output="study", seeds=2)
        with self.assertRaisesRegex(mesopix.Error, "^output: study holds another study; scene loading.velocity was"):
            mesopix.study(samples.specimen(), {**FAST, "loading.velocity": 0.2}, output="study", seeds=2)
        self.assertEqual(len(mesopix.study(samples.specimen(), FAST, output="study", seeds=2)), 2)

    def test_knows_a_specimen_whose_history_is_worded_otherwise(self):
        mesopix.study(samples.specimen(), FAST, output="study", seeds=1)
        with h5py.File("study/specimen.h5", "r+") as file:
            options = file["provenance/options"]
            text = options[0]
            options[0] = text.replace(b"# of the random aggregates", b"# of aggregates at random ")
            self.assertNotEqual(options[0], text)
        self.assertEqual(len(mesopix.study(samples.specimen(), FAST, output="study", seeds=1)), 1)

    def test_arrays_outlive_the_study(self):
        study = mesopix.study(samples.specimen(), FAST, output="study", seeds=2)
        peaks, stress, counts = study.table["peak_stress"], study.curves[0].stress, study.crack_counts
        copies = peaks.copy(), stress.copy(), counts.copy()
        del study
        for array, copy in zip((peaks, stress, counts), copies):
            np.testing.assert_array_equal(array, copy)
            with self.assertRaises(ValueError):
                array[0] = 1


if __name__ == "__main__":
    unittest.main()
