// For the sanitizer builds: HDF5 1.10 forgets what it had unpacked when a checksum fails.
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming): the sanitizer chose the name
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }
