"""stiffness."""
import unittest
import numpy as np
import mesopix, samples


class Stiffness(unittest.TestCase):
    def test_lies_within_its_bounds(self):
        figures = mesopix.stiffness(samples.specimen(), {"mortar.young": "25 GPa"}, plane="stress", cell="pixel")
        self.assertEqual(figures["phases"]["mortar"]["young_Pa"], 25e9)
        young = [figures[one]["young_Pa"] for one in ("uniform_stress", "periodic", "uniform_strain")]
        low, high = (figures["bounds"][one]["young_Pa"] for one in ("reuss", "voigt"))
        self.assertEqual(sorted([low, *young, high]), [low, *young, high])
        tensor = np.array(figures["periodic"]["stiffness_Pa"])
        self.assertEqual(tensor.shape, (3, 3))
        np.testing.assert_array_equal(tensor, tensor.T)

    def test_refuses_what_has_no_effect(self):
        with self.assertRaisesRegex(mesopix.Error, "mortar.tensile_scale: has no effect on the stiffness"):
            mesopix.stiffness(samples.specimen(), {"mortar.tensile_scale": "3 MPa"})
        with self.assertRaises(mesopix.Error):
            mesopix.stiffness(samples.specimen(), velocity=0.1)


if __name__ == "__main__":
    unittest.main()
