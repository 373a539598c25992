/* atlas_head.c - two lines of comments and one of names. */
#include "cli/atlas/atlas_head.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const char form[] =
    "# pepperpot-atlas-1: daylight factors, per cent of the open "
    "sky's horizontal illuminance\n";

char *pp_atlas_head_text(const struct pp_atlas_making *making,
                         const struct pp_atlas_columns *columns)
{
    char *head = NULL;
    size_t length;
    FILE *out = open_memstream(&head, &length);
    if (!out)
        return NULL;
    fprintf(out, "%s# sky %s, error %g %%, seed %llu\n", form,
            making->sky == PP_ATLAS_ISO ? "iso" : "overcast",
            100.0 * making->trace.error, (unsigned long long)making->trace.seed);
    pp_atlas_columns_print_names(columns, out);
    if (fclose(out) == 0)
        return head;
    free(head);
    return NULL;
}

/* The second line. */
static bool read_making(struct pp_atlas_making *making, const char *line)
{
    char sky[16];
    unsigned long long seed;
    if (sscanf(line, "# sky %15[a-z], error %lf %%, seed %llu", sky,
               &making->trace.error, &seed)
        != 3)
        return false;
    making->trace.error *= 0.01;
    making->trace.seed = seed;
    making->sky = strcmp(sky, "iso") == 0 ? PP_ATLAS_ISO : PP_ATLAS_OVERCAST;
    return strcmp(sky, "iso") == 0 || strcmp(sky, "overcast") == 0;
}

enum pp_status pp_atlas_head_read(struct pp_atlas_making *making, const char *path,
                                  struct pp_error *err)
{
    char first[sizeof form + 1], second[128];
    FILE *in = fopen(path, "r");
    if (!in)
        return pp_fail(err, errno == ENOENT ? PP_BAD_INPUT : PP_SYSTEM,
                       "%s can't be read: %s", path, strerror(errno));
    bool is_one = fgets(first, sizeof first, in) && strcmp(first, form) == 0
                  && fgets(second, sizeof second, in) && read_making(making, second);
    fclose(in);
    return is_one ? PP_OK
                  : pp_fail(err, PP_BAD_INPUT,
                            "%s:1: this is no atlas; expected a file that pepperpot "
                            "atlas -o has written",
                            path);
}
