/* read_sky.c - see read_sky.h. */
#include "model/room/read/read_sky.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/pictures/sky_picture_file.h"
#include "model/room/sky_words.h"

/* Reads the options of a photograph; false after a mistake. */
static bool read_options(struct pp_reader *r, struct pp_sky_picture_options *options,
                         const struct pp_sky_form *form, int line)
{
    bool good = true;
    *options = pp_sky_picture_options_none();
    options->sun_altitude_rad = form->sun_altitude_rad;
    options->sun_bearing_rad = form->sun_bearing_rad;
    for (int i = 0; i < PP_SKY_FORM_OPTIONS; i++) {
        struct pp_error fault;
        if (!form->picture[i]
            || pp_sky_picture_options_set(options, pp_sky_form_keys[i],
                                          form->picture[i], &fault)
                   == PP_OK)
            continue;
        pp_mistakes_add(r->mistakes, line, "sky: %s", fault.message);
        good = false;
    }
    return good;
}

static struct pp_sky_picture *read_files(struct pp_reader *r,
                                         const struct pp_sky_form *form,
                                         const struct pp_sky_picture_options *options,
                                         int line)
{
    struct pp_sky_picture *picture = NULL;
    struct pp_error fault = {0};
    char *path = pp_reader_path(r, form->file);
    char *second = form->second ? pp_reader_path(r, form->second) : NULL;
    if (path && (second || !form->second)
        && pp_sky_picture_file_read(&picture, path, second, options, &fault) != PP_OK)
        pp_mistakes_add(r->mistakes, line, "sky: %s", fault.message);
    free(path);
    free(second);
    return picture;
}

/* Reads a photograph; false after a mistake. */
static bool read_photograph(struct pp_reader *r, struct pp_sky_part *part,
                            const struct pp_sky_form *form)
{
    struct pp_sky_picture_options options;
    if (!form->file)
        pp_mistakes_add(r->mistakes, part->line,
                        "sky: type \"picture\" needs a file; expected the name of a "
                        "photograph");
    else if (!r->folder)
        pp_mistakes_add(r->mistakes, part->line,
                        "sky: the room was not read from a file, so its picture cannot "
                        "be located; expected a room read from a file");
    else if (read_options(r, &options, form, part->line))
        part->picture = read_files(r, form, &options, part->line);
    return part->picture != NULL;
}

/* First given attribute of a photograph; NULL: none. */
static const char *given_option(const struct pp_sky_form *form)
{
    if (form->file || form->second)
        return form->file ? "file" : "second";
    for (int i = 0; i < PP_SKY_FORM_OPTIONS; i++)
        if (form->picture[i])
            return pp_sky_form_keys[i];
    return NULL;
}

/* Checks a sky given by a formula; false after a mistake. */
static bool read_formula(struct pp_reader *r, const struct pp_sky_part *part,
                         const struct pp_sky_form *form)
{
    bool altitude = !isnan(form->sun_altitude_rad),
         bearing = !isnan(form->sun_bearing_rad);
    const char *stray = given_option(form);
    if (stray)
        pp_mistakes_add(r->mistakes, part->line,
                        "sky: %s applies only to photographs; expected "
                        "type=\"picture\"",
                        stray);
    bool sunless =
        part->iso > 0 && pp_sky_iso_has_sun(part->iso) && !(altitude && bearing);
    if (sunless)
        pp_mistakes_add(r->mistakes, part->line,
                        "sky: %s needs the position of the sun; %s missing",
                        pp_sky_words[form->type],
                        altitude  ? "sun-bearing is"
                        : bearing ? "sun-altitude is"
                                  : "sun-altitude and sun-bearing are");
    return !stray && !sunless;
}

void pp_read_sky(struct pp_reader *r, struct pp_sky_part *sky,
                 const struct pp_xml_element *e)
{
    struct pp_sky_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_sky, e))
        return;
    struct pp_sky_part part = {.sun_altitude_rad = form.sun_altitude_rad,
                               .sun_bearing_rad = form.sun_bearing_rad,
                               .line = e->line};
    pp_sky_words_set_type(&part, form.type);
    bool good = part.kind == PP_SKY_PICTURE ? read_photograph(r, &part, &form)
                                            : read_formula(r, &part, &form);
    if (!good)
        return;
    pp_sky_words_clear(sky);
    *sky = part;
}
