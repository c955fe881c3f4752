"""twin and Twins."""
import os, signal, threading, unittest
import numpy as np
import mesopix, samples


class Twin(unittest.TestCase):
    def setUp(self):
        folder = samples.empty_folder()
        folder.__enter__()
        self.addCleanup(folder.__exit__, None, None, None)

    def test_draws_specimens_like_an_original(self):
        told = []
        twins = mesopix.twin(samples.specimen(), output="twins", count=3, seed=5, progress=told.append)
        self.assertEqual([(p.done, p.all) for p in told], [(1, 3), (2, 3), (3, 3)])
        self.assertEqual(len(twins), 3)
        share = [np.mean(one.labels == one.phases.index("aggregate")) for one in [twins.original, *twins]]
        np.testing.assert_allclose(share[1:], share[0], atol=0.05)
        np.testing.assert_array_equal(twins.original.labels, samples.specimen().labels)
        np.testing.assert_array_equal(twins[-1].labels, twins[2].labels)
        self.assertTrue(np.any(twins[0].labels != twins[1].labels))
        self.assertRegex(repr(twins), "^<mesopix.Twins: 3 twins of specimen, 30 mm x 30 mm")
        self.assertEqual(len(twins.summary["twins"]), 3)
        self.assertTrue(os.path.exists("twins/report.html"))
        with self.assertRaises(IndexError):
            twins[3]

    def test_takes_a_picture_as_the_program_does(self):
        samples.specimen().write("cut.png")
        twins = mesopix.twin("cut.png", output="twins", width="30 mm", count=1, twin_width=0.02, twin_height="15 mm")
        self.assertAlmostEqual(twins[0].width, 0.02)
        self.assertAlmostEqual(twins[0].height, 0.015)

    def test_twins_are_broken_by_their_study(self):
        twins = mesopix.twin(samples.specimen(), output="twins", count=2)
        study = mesopix.study(twins.folder + "/study.toml", output="broken")
        self.assertEqual(list(study.table["state"]), ["done", "done"])

    def test_ends_where_progress_stops_the_iteration_with_those_made(self):
        def progress(p):
            raise StopIteration

        twins = mesopix.twin(samples.specimen(), output="twins", count=200, progress=progress)
        self.assertTrue(1 <= len(twins) < 200)

    def test_ctrl_c_keeps_the_twins_that_were_made(self):
        def press(p):
            if p.done == 1:
                threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()

        with self.assertRaises(mesopix.Interrupted) as raised:
            mesopix.twin(samples.specimen(), output="twins", count=1000, progress=press)
        self.assertGreaterEqual(len(raised.exception.result), 1)

    def test_says_what_is_wrong(self):
        for message, wanted in {
            "^count: 0; must lie in": {"count": 0},
            "^twin_width: .*must be > 0": {"twin_width": -1},
            "^border: round; must be auto, cut or whole": {"border": "round"},
        }.items():
            with self.assertRaisesRegex(mesopix.Error, message):
                mesopix.twin(samples.specimen(), output="twins", **wanted)
        self.assertFalse(os.path.exists("twins"))


if __name__ == "__main__":
    unittest.main()
