// Built into programs under the address sanitizer only: fontconfig, which finds the face for the words in
// curve.png, keeps its tables until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
