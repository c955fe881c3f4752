"""Arrays show memory of C++: none is copied, none can be written, each keeps its owner alive."""
import gc, unittest, weakref
import numpy as np
import mesopix, samples


def address(array):
    return array.__array_interface__["data"][0]


class Views(unittest.TestCase):
    def setUp(self):
        self.result = samples.run(crack_closure="clipped")

    def views(self):
        result = self.result
        return {
            "labels": result.specimen.labels, "history": result.history, "strain": result.curve.strain,
            "stress": result.curve.stress, "failure_strain": result.failure_strain, "failure_mode": result.failure_mode,
            "crush_strain": result.crush_strain}

    def test_are_no_copies(self):
        first, second = self.views(), self.views()
        for name in first:
            self.assertEqual(address(first[name]), address(second[name]), name)
            self.assertTrue(np.shares_memory(first[name], second[name]), name)
        self.assertTrue(np.shares_memory(first["stress"], first["history"]))
        specimen = samples.specimen()
        self.assertEqual(address(specimen.labels), address(specimen.labels))

    def test_cannot_be_written(self):
        for name, array in self.views().items():
            with self.assertRaises(ValueError, msg=name):
                array[0] = array[1]
            with self.assertRaises(ValueError, msg=name):
                array.flags.writeable = True

    def test_outlive_their_owner(self):
        views = self.views()
        copies = {name: array.copy() for name, array in views.items()}
        del self.result
        gc.collect()
        others = [samples.run(seed=seed) for seed in range(5)]  # which would take the memory
        for name in views:
            np.testing.assert_array_equal(views[name], copies[name], err_msg=name)
        self.assertEqual(len(others), 5)

    def test_of_a_specimen_outlive_it(self):
        labels = samples.specimen().labels
        copy = labels.copy()
        gc.collect()
        others = [samples.specimen(seed) for seed in range(5)]
        np.testing.assert_array_equal(labels, copy)
        self.assertEqual(len(others), 5)

    def test_know_their_owner(self):
        specimen = samples.specimen()
        self.assertIs(specimen.labels.base, specimen)
        self.assertIs(self.result.failure_strain.base, self.result)
        self.assertIs(self.result.history.base, self.result)

    def test_let_go_of_their_owner_with_the_last_of_them(self):
        views = self.views()
        owner = weakref.ref(self.result)
        del self.result
        gc.collect()
        self.assertIsNotNone(owner())
        for name in list(views):
            del views[name]
        gc.collect()
        self.assertIsNone(owner())


if __name__ == "__main__":
    unittest.main()
