"""Mistakes are told with field, value, what is allowed, and the cure."""
import pickle, unittest
import numpy as np
import mesopix, samples


class Errors(unittest.TestCase):
    def refused(self, kind, *arguments, call=mesopix.simulate, **options):
        with self.assertRaises(kind) as raised:
            call(*arguments, **options)
        return raised.exception

    def test_name_the_argument_as_it_was_written(self):
        error = self.refused(mesopix.Error, samples.specimen(), velocity=-1)
        self.assertEqual((error.field, error.value, error.allowed), ("velocity", "-1", "must be > 0"))
        self.assertEqual(str(error), "velocity: -1; must be > 0")
        self.assertIsInstance(error, ValueError)
        error = self.refused(mesopix.Error, samples.specimen(), {"loading.velocity": "5"})
        self.assertEqual(str(error), 'loading.velocity: 5; needs a unit; write e.g. "0.05 m/s"')

    def test_are_told_all_at_once(self):
        error = self.refused(mesopix.Error, samples.specimen(), velocty=1, cfl=None, platen="sticky")
        self.assertEqual(str(error), 'velocty: unknown option; did you mean velocity?\ncfl: None; must be a number, a '
                         'text such as "0.5 mm", True or False, or a sequence of these')
        error = self.refused(mesopix.Error, samples.specimen(), cfl=2, platen="sticky")
        self.assertEqual([complaint.field for complaint in error.complaints], ["cfl", "platen"])

    def test_a_setting_is_given_once(self):
        error = self.refused(mesopix.Error, samples.specimen(), {"loading.velocity": 1}, velocity=2)
        self.assertEqual(str(error), "velocity: 2; is given twice; give it once")

    def test_a_setting_without_effect_is_a_mistake(self):
        error = self.refused(mesopix.Error, samples.specimen(), flip_ratio=0.5)
        self.assertIn('has an effect with solver.kinematics = "moving" or "auto" only', str(error))
        error = self.refused(mesopix.Error, samples.specimen(), {"generate.width": 1})
        self.assertEqual(error.allowed, "has no effect on a specimen that is there already")
        error = self.refused(mesopix.Error, samples.specimen(), {"specimen.file": "a.h5"})
        self.assertEqual(str(error), "specimen.file: a.h5; given beside a specimen; remove it")
        error = self.refused(mesopix.Error, samples.specimen(), frames=3)
        self.assertIn("give that folder as output", error.cure)

    def test_of_the_libraries_too(self):
        error = self.refused(mesopix.Error, call=mesopix.generate, fraction=0.95)
        self.assertEqual(error.field, "fraction")
        error = self.refused(mesopix.Error, np.zeros((30, 30)), call=mesopix.convert)
        self.assertIn("give pixel_size 0.5mm or width 150mm", error.cure)

    def test_of_a_scene_tell_the_line(self):
        with samples.empty_folder():
            with open("scene.toml", "w") as scene:
                scene.write('[loading]\nvelocity = "fast"\n')
            error = self.refused(mesopix.Error, "scene.toml")
            self.assertEqual(error.place, "scene.toml:2:12")
            self.assertTrue(str(error).startswith("scene.toml:2:12: loading.velocity: "))

    def test_of_files_are_errors_of_the_system(self):
        error = self.refused(mesopix.FileError, "nothing.h5")
        self.assertIsInstance(error, OSError)
        self.assertEqual(str(error), "nothing.h5: No such file or directory; must be a file that can be read")
        self.refused(mesopix.FileError, "nothing.h5", call=mesopix.read_specimen)
        self.refused(mesopix.FileError, "nothing", call=mesopix.read_result)
        self.refused(mesopix.FileError, "/proc/none/a.h5", call=samples.specimen().write)
        error = self.refused(mesopix.Error, "a.xyz", call=samples.specimen().write)
        self.assertEqual(error.field, "path")

    def test_of_arrays_tell_their_shape(self):
        for image, value in ((np.zeros((4, 4, 4), np.uint8), "uint8 of shape (4, 4, 4)"),
                             (np.zeros((4, 4, 3)), "float64 of shape (4, 4, 3)"),
                             (np.zeros(4), "float64 of shape (4,)"),
                             (np.zeros((0, 4)), "float64 of shape (0, 4)"),
                             (np.full((4, 4), np.nan), "a value that is not finite"),
                             (np.zeros((4, 4), complex), "complex128 of shape (4, 4)")):
            error = self.refused(mesopix.Error, image, call=mesopix.convert, width=1)
            self.assertEqual((error.field, error.value), ("image", value))

    def test_of_type_are_those_of_python(self):
        self.refused(TypeError, 3)
        self.refused(TypeError, samples.specimen(), call=mesopix.read_specimen)

    def test_travel_between_processes(self):
        for error in (self.refused(mesopix.Error, samples.specimen(), velocity=-1),
                      self.refused(mesopix.FileError, "nothing.h5")):
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(again), str(again), again.field), (type(error), str(error), error.field))


class Help(unittest.TestCase):
    def test_lists_the_settings_of_the_schema(self):
        text = mesopix.simulate.__doc__
        self.assertIn("    loading:\n        direction: tension|compression|none = tension\n", text)
        self.assertIn("        velocity: VELOCITY = 0.05 m/s\n            of the top platen\n", text)
        self.assertIn('    phases, each {"PHASE.young": ...}:\n        PHASE.young: PRESSURE = 20 GPa\n', text)
        self.assertIn("        separation: BOOLEAN = False\n", text)
        self.assertIn("        fraction: NUMBER = 0.45\n", mesopix.generate.__doc__)
        self.assertNotIn(" fraction: ", text)


if __name__ == "__main__":
    unittest.main()
