#include "specimen/picture/tiff_handle.hpp"

#include <cstdarg>
#include <cstdio>

namespace specimen {
namespace {

[[gnu::format(printf, 4, 0)]] int on_error(TIFF*, void* user_data, const char*, const char* format,
                                           va_list arguments) {
  auto* messages = static_cast<TiffMessages*>(user_data);
  if (messages->text[0] == '\0')
    (void)std::vsnprintf(messages->text.data(), messages->text.size(), format, arguments);
  return 1;  // told here, not on the terminal
}

int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

}  // namespace

TiffOptions quiet_options(TiffMessages& messages) {
  TiffOptions options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), largest_allocation);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &messages);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
  return options;
}

}  // namespace specimen
