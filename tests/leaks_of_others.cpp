// Leaks that are not ours, for the sanitizer builds: HDF5 1.10 forgets what it had unpacked when a checksum fails.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }  // NOLINT: the sanitizer's name
