// Built into programs under the address sanitizer only, for leaks of others: fontconfig, which finds the face
// for the words in curve.png, keeps its tables until the process ends; HDF5 1.10 forgets what it had unpacked
// when a checksum fails.
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming): the sanitizer chose the name
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\nleak:libhdf5\n"; }

// Its report of what it suppressed would stand among the messages of the program.
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
