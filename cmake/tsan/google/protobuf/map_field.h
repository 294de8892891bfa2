// With -fsanitize=thread this header gives maps two more members, which those in Debian's libprotobuf do not have: maps of
// its messages would be read at wrong addresses. Here they get the layout of the library.
#pragma once
// they have a layout of their own with the sanitizer, which stays
#include <atomic>
#include <memory>
#include <mutex>
#pragma push_macro("__SANITIZE_THREAD__")
#undef __SANITIZE_THREAD__
#include_next <google/protobuf/map_field.h>  // IWYU pragma: export
#pragma pop_macro("__SANITIZE_THREAD__")
