/* release_fonts.c - in a build with sanitizers, frees the memory that pango, cairo and
 * fontconfig keep until a process ends. To suppress these as leaks the sanitizer would
 * read the libraries' symbols, which takes as long as a chart. */
#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <stdlib.h>

static void release(void)
{
    pango_cairo_font_map_set_default(NULL);
    cairo_debug_reset_static_data();
    FcFini();
}

__attribute__((constructor)) static void release_at_exit(void)
{
    atexit(release);
}
