"""generate, convert, read_specimen and Specimen."""
import os, unittest
import numpy as np
import mesopix, samples


class Generate(unittest.TestCase):
    def test_gives_a_mask_of_the_size_asked_for(self):
        specimen = samples.specimen()
        self.assertEqual(specimen.labels.shape, (60, 60))
        self.assertEqual(specimen.labels.dtype, np.uint8)
        self.assertEqual(specimen.pixel_size, 0.5e-3)
        self.assertAlmostEqual(specimen.width, 0.03)
        self.assertEqual(specimen.phases[:4], ("void", "aggregate", "mortar", "itz"))
        self.assertAlmostEqual(np.mean(specimen.labels == 1), 0.3, delta=0.01)
        self.assertEqual(specimen.summary["aggregates"]["count"], 12)

    def test_numbers_are_in_si_units_and_keys_name_the_same_settings(self):
        numbers = mesopix.generate(
            {"generate.width": 0.03, "generate.d_min": 4e-3}, height=np.float64(0.03), d_max=0.008, fraction=0.3,
            seed=np.int64(3))
        np.testing.assert_array_equal(numbers.labels, samples.specimen().labels)

    def test_seeds_make_a_difference(self):
        self.assertFalse(np.array_equal(samples.specimen(1).labels, samples.specimen(2).labels))

    def test_draws_the_specimen_of_a_scene(self):
        with samples.empty_folder():
            with open("scene.toml", "w") as scene:
                scene.write('[generate]\nwidth = "20 mm"\nheight = "10 mm"\nd_min = "2 mm"\nd_max = "4 mm"\nfraction = 0\n')
            self.assertEqual(mesopix.generate(scene="scene.toml").labels.shape, (20, 40))
            self.assertEqual(mesopix.generate(scene="scene.toml", height=0.02).labels.shape, (40, 40))

    def test_tells_what_it_is(self):
        self.assertEqual(
            repr(samples.specimen()),
            "<mesopix.Specimen: specimen 30 mm x 30 mm, 60 x 60 pixels of 0.5 mm, generated with seed 3; aggregate 29.9 %; "
            "mortar 57.9 %; itz 12.2 %>")


class Convert(unittest.TestCase):
    def test_labels_stay_what_they_are(self):
        labels = samples.specimen().labels
        for image in (labels, labels.astype(np.int64), labels.astype(np.float32), np.asfortranarray(labels), labels.tolist()):
            same = mesopix.convert(image, pixel_size="0.5 mm")
            np.testing.assert_array_equal(same.labels, labels)
            self.assertEqual(same.pixel_size, 0.5e-3)

    def test_row_0_is_the_top(self):
        labels = np.full((20, 30), 2)
        labels[:5, :10] = 1
        specimen = mesopix.convert(labels, width=0.03, itz_mode="none")
        self.assertEqual(specimen.labels.shape, (20, 30))
        np.testing.assert_array_equal(specimen.labels, labels)

    def test_values_get_their_phases_from_a_dictionary(self):
        labels = np.full((20, 20), 7)
        labels[5:10, 5:10] = 9
        specimen = mesopix.convert(
            labels, pixel_size=1e-3, label_phases={7: "mortar", 9: "aggregate"}, itz_mode="none")
        np.testing.assert_array_equal(specimen.labels, np.where(labels == 7, 2, 1))

    def test_colours_are_told_apart(self):
        image = np.zeros((40, 40, 3), np.uint8)
        image[:] = (200, 190, 180)
        image[10:30, 10:30] = (90, 60, 50)
        specimen = mesopix.convert(image, width="40 mm", itz_mode="none")
        self.assertEqual(len(np.unique(specimen.labels)), 2)
        self.assertEqual(len(np.unique(specimen.labels[12:28, 12:28])), 1)
        self.assertTrue(specimen.notes)

    def test_a_file_and_its_pixels_are_the_same(self):
        with samples.empty_folder():
            self.assertEqual(samples.specimen().write("labels.png"), ["labels.png"])
            from_file = mesopix.convert("labels.png")
            np.testing.assert_array_equal(from_file.labels, samples.specimen().labels)
            self.assertAlmostEqual(from_file.pixel_size, 0.5e-3, places=8)

    def test_provenance_tells_arrays_apart(self):
        labels = np.full((20, 20), 2)
        first = mesopix.convert(labels, pixel_size=1e-3).summary["source"]
        labels[4:8, 4:8] = 1
        second = mesopix.convert(labels, pixel_size=1e-3).summary["source"]
        self.assertEqual(first["from"], "array")
        self.assertRegex(first["sha256"], "^[0-9a-f]{64}$")
        self.assertNotEqual(first["sha256"], second["sha256"])


class Files(unittest.TestCase):
    def test_a_specimen_comes_back(self):
        with samples.empty_folder() as folder:
            written = samples.specimen().write(os.path.join(folder, "a.h5"))
            self.assertEqual([os.path.basename(name) for name in written], ["a.h5", "a_preview.png"])
            again = mesopix.read_specimen("a.h5")
            np.testing.assert_array_equal(again.labels, samples.specimen().labels)
            self.assertEqual(again.summary, samples.specimen().summary)

    def test_notebooks_see_a_picture(self):
        self.assertTrue(samples.specimen()._repr_png_().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
