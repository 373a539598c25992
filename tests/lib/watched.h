/* watched.h - whether AddressSanitizer watches every access of this build, which takes ten
 * times as long for the same. A test of hundreds of cases or of millions of paths has fewer of
 * them there, with the tolerance that goes with so many: a mistake of memory shows in the first
 * as in the last, and the other builds have all.
 */
#ifndef PP_TESTS_LIB_WATCHED_H
#define PP_TESTS_LIB_WATCHED_H

#if defined __SANITIZE_ADDRESS__
#define PP_WATCHED 1
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define PP_WATCHED 1
#endif
#endif
#ifndef PP_WATCHED
#define PP_WATCHED 0
#endif

#endif
