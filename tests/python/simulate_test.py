"""simulate, read_result and Result."""
import concurrent.futures, json, os, shutil, signal, threading, time, unittest, warnings
import numpy as np
import mesopix, samples


class Simulate(unittest.TestCase):
    def test_gives_a_curve_with_its_peak(self):
        result = samples.run()
        self.assertEqual(result.stop, "strain")
        self.assertEqual(result.peak_stress, result.curve.stress.max())
        self.assertEqual(result.peak_strain, result.curve.strain[result.curve.stress.argmax()])
        self.assertGreater(result.peak_stress, 2e6)
        self.assertLess(result.peak_stress, 5e6)
        self.assertEqual(result.curve.strain[0], 0)
        self.assertTrue(np.all(np.diff(result.curve.strain) > 0))
        self.assertAlmostEqual(result.curve.strain[-1], 3e-4, delta=3e-6)

    def test_gives_no_number_for_a_peak_that_is_none(self):
        rising = samples.run(stop_strain=2e-5)
        self.assertFalse(rising.peak_reached)
        self.assertTrue(np.isnan(rising.peak_stress))
        self.assertTrue(np.isnan(rising.peak_strain))
        self.assertGreater(rising.largest_stress, 0)
        self.assertLessEqual(rising.largest_stress, rising.curve.stress.max())  # that of the platen that bears less
        self.assertEqual(rising.strain_at_largest_stress, rising.curve.strain[-1])
        self.assertIsNone(rising.summary["peak_stress_Pa"])
        with self.assertRaisesRegex(ValueError, "has no peak_strain"):
            rising.damage(rising.peak_strain)
        self.assertIn("no estimate of the error", " ".join(samples.run(stop_strain=2e-5, estimate_error=True).notes))

    def test_tells_what_a_long_run_takes_before_it(self):
        def stop(progress):
            raise StopIteration

        with self.assertWarnsRegex(mesopix.LongRun, "^a run of [0-9]+ points and [0-9]+ steps of .*, which takes about") as told:
            mesopix.simulate(samples.specimen(), velocity=1e-5, stop_strain=1e-3, progress=stop)
        self.assertEqual(told.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(mesopix.LongRun):
                mesopix.simulate(samples.specimen(), velocity=1e-5, stop_strain=1e-3)
            samples.run()

    def test_asks_before_a_picture_is_computed_for_hours(self):
        with samples.empty_folder():
            with open("photo.pgm", "wb") as photo:
                grains = (np.add.outer(np.arange(900) // 30, np.arange(900) // 30) % 2 * 200).astype(np.uint8)
                photo.write(b"P5 900 900 255\n" + grains.tobytes())
            with self.assertRaisesRegex(mesopix.Error, "^convert.pixels: auto, 900 columns; a run of .* must be asked for"):
                mesopix.simulate("photo.pgm", velocity=1e-6, **{"convert.width": "150 mm"})

    def test_is_the_run_of_the_scene_that_it_writes_out(self):
        with samples.empty_folder():
            samples.specimen().write("specimen.h5")
            with open("scene.toml", "w") as scene:
                scene.write(samples.run().scene)
            np.testing.assert_array_equal(mesopix.simulate("scene.toml").curve.stress, samples.run().curve.stress)

    def test_takes_settings_by_key_and_by_name(self):
        named = samples.run(**{"mortar.tensile_scale": 12e6})
        keyed = mesopix.simulate(samples.specimen(), {
            "phases.mortar.tensile_scale": "12 MPa", "loading.velocity": "0.2 m/s", "loading.stop_strain": "300 microstrain",
            "output.history_rows": 100, "solver.threads": 1})
        np.testing.assert_array_equal(named.curve.stress, keyed.curve.stress)
        self.assertLess(named.peak_stress, samples.run().peak_stress)
        self.assertIn('tensile_scale = "12 MPa"', named.scene)

    def test_seeds_make_a_difference(self):
        self.assertEqual(samples.run(seed=5).summary["seed"], 5)
        self.assertNotEqual(samples.run(seed=5).peak_stress, samples.run(seed=6).peak_stress)

    def test_leaves_the_specimen_alone_and_crops_it_to_whole_cells(self):
        specimen = mesopix.generate(width="10.5 mm", height="10 mm", d_min="2 mm", d_max="4 mm", fraction=0)
        result = mesopix.simulate(specimen, velocity=0.5, stop_strain=2e-5, cell="2 x 2")
        self.assertEqual(specimen.labels.shape, (20, 21))
        self.assertEqual(result.specimen.labels.shape, (20, 20))
        self.assertIn("cropped from 21 x 20 to 20 x 20 pixels", result.notes[0])

    def test_estimates_its_error(self):
        result = samples.run(estimate_error=True, stop_drop=0.5)
        error = result.summary["error_estimate"]
        self.assertGreater(error["peak_stress_error"], 0)
        self.assertEqual({source["name"] for source in error["sources"]},
                         {"loading rate", "time step", "precision", "pixel size"})

    def test_meets_a_tolerance_or_says_so(self):
        result = samples.run(tolerance="40 %")
        self.assertNotIn('velocity = "0.2 m/s"', result.scene)
        self.assertLess(result.summary["error_estimate"]["peak_stress_error"], 0.4)
        with self.assertRaisesRegex(mesopix.Error, "^tolerance: 0.01 %; not met: at .* m/s the peak may still be wrong"):
            samples.run(tolerance=1e-4, crack_closure="unilateral")


class Result(unittest.TestCase):
    def test_damage_grows_to_what_failed_in_the_end(self):
        result = samples.run()
        shares = [np.mean(result.damage(strain) != 0) for strain in (0, result.peak_strain, 3e-4)]
        self.assertEqual(shares[0], 0)
        self.assertTrue(0 < shares[1] < shares[2])
        np.testing.assert_array_equal(result.damage(), result.failure_mode)
        self.assertEqual(np.count_nonzero(result.damage()), result.tension_failures + result.shear_failures)
        self.assertEqual(np.count_nonzero(np.isnan(result.failure_strain)), np.count_nonzero(result.failure_mode == 0))

    def test_history_has_the_columns_of_the_table(self):
        with samples.empty_folder():
            result = samples.run()
            result.save("run")
            with open("run/curve.csv") as table:
                header = table.readline().strip().split(",")
            self.assertEqual(len(result.history.dtype.names), len(header))
            rows = np.loadtxt("run/curve.csv", delimiter=",", skiprows=1)
            for column, name in enumerate(result.history.dtype.names):
                np.testing.assert_allclose(result.history[name], rows[:, column], rtol=1e-12, err_msg=name)

    def test_has_no_maps_of_what_was_not_asked_for(self):
        self.assertIsNone(samples.run().crush_strain)
        self.assertIsNone(samples.run().end_x)
        self.assertEqual(samples.run(kinematics="moving", stop_strain=5e-5).end_x.shape, (60, 60))

    def test_saves_the_folder_of_the_program(self):
        with samples.empty_folder():
            result = samples.run()
            result.save("run")
            for name in ("report.html", "curve.csv", "result.h5", "specimen.h5", "scene.toml", "damage_100.png"):
                self.assertTrue(os.path.exists(f"run/{name}"), name)
            with open("run/summary.json") as summary:
                saved = json.load(summary)
            self.assertEqual(saved.pop("scene_hash") != "", True)
            mine = result.summary
            del mine["scene_hash"]  # the scene tells where the specimen is
            self.assertEqual(saved, mine)
            again = mesopix.simulate("run/scene.toml")
            np.testing.assert_array_equal(again.curve.stress, result.curve.stress)
            with self.assertRaisesRegex(mesopix.Error, "folder: run; is not empty; choose another folder, or add overwrite"):
                result.save("run")
            result.save("run", overwrite=True)

    def test_comes_back_from_its_folder(self):
        with samples.empty_folder():
            result = samples.run()
            result.save("run")
            again = mesopix.read_result("run")
            np.testing.assert_array_equal(again.history, result.history)
            np.testing.assert_array_equal(again.failure_strain, result.failure_strain)
            np.testing.assert_array_equal(again.specimen.labels, result.specimen.labels)
            again.save("elsewhere/run")
            np.testing.assert_array_equal(mesopix.simulate("elsewhere/run/scene.toml").curve.stress, result.curve.stress)

    def test_writes_its_folder_on_the_way_with_frames(self):
        with samples.empty_folder():
            samples.run(output="run", frames=3)
            self.assertEqual(len(os.listdir("run/frames")), 4)
            self.assertTrue(os.path.exists("run/report.html"))

    def test_tells_what_it_is(self):
        self.assertRegex(
            repr(samples.run()),
            r"^<mesopix.Result: peak \d\.\d+ MPa at strain [\d.]+e-6; \d+ tension and \d+ shear failures; .+>$")

    def test_plots_into_the_axes_that_it_is_given(self):
        class Axes:
            def plot(self, x, y, **line): self.drawn = x, y, line
            def set_xlabel(self, text): self.x = text
            def set_ylabel(self, text): self.y = text
        axes, result = Axes(), samples.run()
        self.assertIs(result.plot(axes, color="k"), axes)
        np.testing.assert_allclose(axes.drawn[0], 1e6 * result.curve.strain)
        np.testing.assert_allclose(axes.drawn[1], 1e-6 * result.curve.stress)
        self.assertEqual((axes.drawn[2], axes.x, axes.y), ({"color": "k"}, "strain [microstrain]", "stress [MPa]"))


class Watched(unittest.TestCase):
    def test_tells_how_far_it_is(self):
        told = []
        result = samples.run(progress=told.append)
        self.assertEqual(len(told), len(result.history) - 1)  # the first row is the state at rest
        self.assertEqual([p.strain for p in told], list(result.curve.strain[1:]))
        self.assertEqual([p.stress for p in told], list(result.curve.stress[1:]))
        self.assertAlmostEqual(told[-1].fraction, 1, delta=0.02)
        self.assertEqual(told[-1].failures, result.tension_failures + result.shear_failures)

    def test_ends_where_progress_stops_the_iteration(self):
        def progress(p):
            if p.strain > 1e-6:
                raise StopIteration

        result = mesopix.simulate(samples.specimen(), progress=progress, **samples.ENDLESS)
        self.assertEqual(result.stop, "interrupted")
        self.assertAlmostEqual(result.curve.strain[-1], 1e-6, delta=2e-8)

    def test_raises_again_what_progress_raises(self):
        class Enough(Exception):
            pass

        def progress(p):
            raise Enough(p.strain)

        with self.assertRaises(Enough):
            mesopix.simulate(samples.specimen(), progress=progress, **samples.ENDLESS)

    def test_ctrl_c_keeps_what_was_computed_while_another_thread_goes_on(self):
        ticks = 0

        def press_after_ticks():
            nonlocal ticks
            while ticks < 1500:  # the run is under way, and its length told
                time.sleep(0.001)
                ticks += 1
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=press_after_ticks)
        thread.start()
        with self.assertRaises(mesopix.Interrupted) as raised:
            mesopix.simulate(samples.specimen(), **samples.ENDLESS)
        thread.join()
        self.assertIsInstance(raised.exception, KeyboardInterrupt)
        self.assertEqual(raised.exception.result.stop, "interrupted")
        self.assertGreater(len(raised.exception.result.history), 10)

    def test_ctrl_c_during_progress_is_the_same(self):
        with self.assertRaises(mesopix.Interrupted) as raised:
            mesopix.simulate(
                samples.specimen(), progress=lambda p: p.strain > 1e-7 and signal.raise_signal(signal.SIGINT),
                **samples.ENDLESS)
        self.assertGreater(raised.exception.result.curve.strain[-1], 1e-7)

    def test_divergence_keeps_what_was_computed(self):
        labels = np.zeros((12, 12))  # pixels alone in their cells beside a block bear no such step
        labels[:, :6] = 2
        labels[::4, 7] = 2
        specimen = mesopix.convert(labels, pixel_size=1e-3, method="labels", label_phases={0: "void", 2: "mortar"})
        with self.assertRaises(mesopix.Diverged) as raised:
            mesopix.simulate(specimen, {"mortar.poisson": 0.4999, "mortar.tensile_scale": "unbreakable"}, cfl=1)
        self.assertIn("step", str(raised.exception))
        self.assertGreater(len(raised.exception.result.history), 0)
        self.assertEqual(raised.exception.result.notes[-1], str(raised.exception))

    def test_a_folder_that_cannot_be_written_loses_no_result(self):
        def progress(p):
            if os.path.isdir("run"):
                shutil.rmtree("run")
                open("run", "w").close()

        with samples.empty_folder():
            with self.assertRaisesRegex(mesopix.FileError, "^run: cannot be created: ") as raised:
                samples.run(output="run", progress=progress)
            np.testing.assert_array_equal(raised.exception.result.curve.stress, samples.run().curve.stress)

    def test_a_folder_is_written_by_one_run_at_a_time(self):
        refused = []

        def progress(p):
            if not refused:
                with self.assertRaisesRegex(mesopix.Error, "^run: another program is writing a run there; ") as raised:
                    samples.run(output="run", overwrite=True)
                refused.append(raised.exception)

        with samples.empty_folder():
            samples.run(output="run", progress=progress)
            self.assertTrue(refused)
            samples.run(output="run", overwrite=True)
            self.assertFalse(os.path.exists("run/in_progress.lock"))

    def test_runs_side_by_side_are_the_same_as_one_by_one(self):
        specimen = samples.specimen()
        settings = dict(velocity=0.2, stop_strain=3e-4, threads=1)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            beside = list(pool.map(lambda seed: mesopix.simulate(specimen, seed=seed, **settings), range(8)))
        for seed, result in enumerate(beside):
            np.testing.assert_array_equal(
                result.curve.stress, mesopix.simulate(specimen, seed=seed, **settings).curve.stress)


if __name__ == "__main__":
    unittest.main()
