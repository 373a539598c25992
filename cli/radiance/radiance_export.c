/* radiance_export.c - writes the files of an export: scene, materials, points,
 * script. */
#include "cli/radiance/radiance_export.h"

#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "formats/radiance/rad_functions.h"
#include "formats/radiance/write/rad_room.h"
#include "formats/radiance/write/rad_write.h"
#include "formats/radiance/write/rad_numbers.h"
#include "formats/radiance/write/rad_write_materials.h"
#include "model/light/bsdf/bsdf_write.h"

static const char materials_name[] = "materials.rad";
static const char points_name[] = "points.pts";

static const struct {
    const char *file, *shapes, *says;
} groups[PP_RAD_GROUPS] = {
    [PP_RAD_ROOM] =
        {"room.rad", "room",
         "the room: floor, walls without their openings, ceiling, reveals, fittings"},
    [PP_RAD_GLAZING] = {"glazing.rad", "pane",
                        "panes, with losses for frames and dirt"},
    [PP_RAD_OUTSIDE] =
        {"outside.rad", "outside",
         "outside: blocks, facades, surfaces, skylines, and the ground shaded by them"},
    [PP_RAD_SKY] = {"sky.rad", "half", "the sky, and the ground as a glow"},
};

const char *const pp_radiance_files[] = {"materials.rad",
                                         "room.rad",
                                         "glazing.rad",
                                         "outside.rad",
                                         "sky.rad",
                                         "points.pts",
                                         PP_RAD_CAL_NAME,
                                         "daylight_factors.sh",
                                         "illuminances.sh",
                                         "scene.oct",
                                         "pane_1.xml",
                                         "pane_2.xml",
                                         "pane_3.xml",
                                         "pane_4.xml",
                                         NULL};

/* Adds a file to the room's folder in the directory. */
static enum pp_status add_file(struct pp_output_directory *directory,
                               const char *folder, const char *name, bool runs,
                               FILE **out, struct pp_error *err)
{
    char *path;
    if (asprintf(&path, "%s%s%s", folder ? folder : "", folder ? "/" : "", name) < 0)
        return pp_fail_memory(err);
    enum pp_status status = pp_output_directory_add(directory, path, runs, out, err);
    free(path);
    return status;
}

/* Prints a comment line; characters that would end the line are replaced. */
static void print_comment(const char *text, FILE *out)
{
    for (; *text; text++)
        fputc((unsigned char)*text < 32 ? ' ' : *text, out);
}

static enum pp_status add_scene_file(struct pp_output_directory *directory,
                                     const char *folder, const char *name,
                                     const char *says, const struct pp_world *world,
                                     FILE **out, struct pp_error *err)
{
    enum pp_status status = add_file(directory, folder, name, false, out, err);
    if (status != PP_OK)
        return status;
    fprintf(*out, "# %s - ", name);
    print_comment(world->name ? world->name : "room", *out);
    fprintf(*out,
            ": %s\n# by " PACKAGE_NAME " " PACKAGE_VERSION
            ", lengths in metres, z up\n",
            says);
    return PP_OK;
}

static enum pp_status export_sensor_points(struct pp_output_directory *directory,
                                           const char *folder,
                                           const struct pp_study_room *room,
                                           struct pp_error *err)
{
    FILE *out;
    enum pp_status status = add_file(directory, folder, points_name, false, &out, err);
    for (int i = 0; i < room->receiver_count && status == PP_OK; i++) {
        const struct pp_receiver *at = &room->receivers[i];
        const double numbers[6] = {at->position.x, at->position.y, at->position.z,
                                   at->normal.x,   at->normal.y,   at->normal.z};
        for (int k = 0; k < 6; k++) {
            char text[32];
            pp_rad_numbers_text(numbers[k], text);
            fprintf(out, "%s%s", k ? " " : "", text);
        }
        fputc('\n', out);
    }
    return status;
}

static const char script[] =
    "set -e\n"
    "cd \"$(dirname \"$0\")\"\n"
    "export LC_ALL=C # numbers have a point\n"
    "# " PP_RAD_CAL_NAME " is found beside the scene.\n"
    "[ -z \"$RAYPATH\" ] || RAYPATH=.:$RAYPATH\n"
    "export RAYPATH\n"
    "\n"
    "horizontal=%s # of the open level ground: %s lx over 179 lm/W\n"
    "options=${*:--ab 22 -lr 0 -ad 16384 -as 0 -aa 0 -lw 1e-7}\n"
    "\n"
    "oconv%s materials.rad%s > scene.oct\n"
    "# shellcheck disable=SC2086 # options are several words\n"
    "irradiances=$(rtrace -h -I -dt 0 $options scene.oct < points.pts)\n"
    "printf '%%s\\n' \"$irradiances\" | paste -d' ' points.pts - |\n"
    "    awk -v horizontal=\"$horizontal\" '\n"
    "    NF != 9 {\n"
    "        print \"rtrace gave fewer irradiances than there are points\" "
    ">\"/dev/stderr\"\n"
    "        exit 1\n"
    "    }\n"
    "    {\n"
    "        grey = 0.265 * $7 + 0.670 * $8 + 0.065 * $9\n"
    "        printf \"%%s %%s %%s %%.5g\\n\", $1, $2, $3, %s * grey / horizontal\n"
    "    }'\n";

/* Writes the option of oconv that sets the size of the smallest cells to 1 cm. By
 * default this is 1/16384 of the size of the scene. Here the ground is kilometres wide,
 * and oconv fails if a cell contains too many surfaces. */
static void resolution_of(const struct pp_rad_room *rad, char *option, size_t size)
{
    static const double CELL_M = 0.01;
    int cells = 16384;
    for (int i = 0; i < rad->scene.shape_count; i++) {
        const struct pp_shape *shape = &rad->scene.shapes[i];
        while (shape->kind == PP_SHAPE_RING && cells < 1 << 30
               && cells * CELL_M < 2.0 * shape->is.ring.radii_m[1])
            cells *= 2;
    }
    if (cells > 16384)
        snprintf(option, size, " -r %d", cells);
    else
        *option = '\0';
}

static enum pp_status add_script(struct pp_output_directory *directory,
                                 const char *folder, const struct pp_rad_room *rad,
                                 double external_lux, bool moment, struct pp_error *err)
{
    FILE *out;
    const char *name = moment ? "illuminances.sh" : "daylight_factors.sh";
    enum pp_status status = add_file(directory, folder, name, true, &out, err);
    if (status != PP_OK)
        return status;
    char irradiance[32], lux[32];
    pp_rad_numbers_text(external_lux / PP_RADIANCE_EFFICACY, irradiance);
    pp_rad_numbers_text(external_lux, lux);
    fprintf(out,
            "#!/bin/sh\n# %s at the points of points.pts, by Radiance's rtrace:\n"
            "# lines \"x y z %s\". Options of rtrace may replace those below,\n# which "
            "follow each path to its end without a cache.\n",
            moment ? "Illuminances (lx)" : "Daylight factors (%)",
            moment ? "lux" : "factor");
    char files[200] = ""; /* only files with content, since oconv warns about empty
                           * files */
    for (int i = 0; i < PP_RAD_GROUPS; i++)
        if (rad->first[i + 1] > rad->first[i])
            snprintf(files + strlen(files), sizeof files - strlen(files), " %s",
                     groups[i].file);
    char resolution[32];
    resolution_of(rad, resolution, sizeof resolution);
    fprintf(out, script, irradiance, lux, resolution, files, moment ? lux : "100");
    return PP_OK;
}

static enum pp_status add_scene(struct pp_output_directory *directory,
                                const char *folder, const struct pp_study_room *room,
                                const struct pp_rad_room *rad,
                                const struct pp_rad_writer *writer,
                                const char *sky_note, struct pp_error *err)
{
    FILE *out;
    enum pp_status status = add_scene_file(directory, folder, materials_name,
                                           "materials, glazings, the sky's brightness",
                                           room->world, &out, err);
    if (status == PP_OK)
        pp_rad_write_materials(writer, out);
    for (int i = 0; i < PP_RAD_GROUPS && status == PP_OK; i++) {
        status = add_scene_file(directory, folder, groups[i].file, groups[i].says,
                                room->world, &out, err);
        if (status == PP_OK && i == PP_RAD_SKY && sky_note)
            fprintf(out, "# %s\n", sky_note);
        if (status == PP_OK)
            pp_rad_write_shapes(writer, groups[i].shapes, rad->first[i],
                                rad->first[i + 1], out);
    }
    return status;
}

/* Writes the data of scattering panes, including the losses due to frame and dirt. */
static enum pp_status add_pane_files(struct pp_output_directory *directory,
                                     const char *folder, const struct pp_rad_room *rad,
                                     struct pp_error *err)
{
    int written = 0;
    for (int i = 0; i < rad->scene.material_count; i++) {
        const struct pp_material *material = &rad->scene.materials[i];
        int number = pp_rad_write_materials_pane(&rad->scene, i);
        char name[32];
        FILE *out;
        if (number <= written)
            continue;
        snprintf(name, sizeof name, PP_RAD_PANE_FILE, number);
        enum pp_status status = add_file(directory, folder, name, false, &out, err);
        if (status != PP_OK)
            return status;
        pp_bsdf_write(out, material->scatter, material->clear_share * material->dirt,
                      "pane of a room");
        written = number;
    }
    return PP_OK;
}

/* True for a Perez sky, with or without sun. The results are then in lux. */
static bool is_of_moment(const struct pp_outside_light *light)
{
    return light->sky.kind == PP_SKY_ISO && light->sky.iso == 0;
}

enum pp_status pp_radiance_export(struct pp_output_directory *directory,
                                  const char *folder, const struct pp_study_room *room,
                                  double external_lux, bool gloss, const char *sky_note,
                                  struct pp_error *err)
{
    struct pp_rad_room rad;
    enum pp_status status =
        pp_rad_room_init(&rad, room->world, &room->light,
                         external_lux / PP_RADIANCE_EFFICACY, gloss, err);
    if (status != PP_OK)
        return status;
    struct pp_rad_writer *writer;
    status = pp_rad_write_create(&writer, &rad.scene, err);
    if (status == PP_OK) {
        status = add_scene(directory, folder, room, &rad, writer, sky_note, err);
        pp_rad_write_destroy(writer);
    }
    if (status == PP_OK)
        status = add_pane_files(directory, folder, &rad, err);
    if (status == PP_OK)
        status = add_script(directory, folder, &rad, external_lux,
                            is_of_moment(&room->light), err);
    pp_rad_room_clear(&rad);
    if (status == PP_OK)
        status = export_sensor_points(directory, folder, room, err);
    FILE *out;
    if (status == PP_OK)
        status = add_file(directory, folder, PP_RAD_CAL_NAME, false, &out, err);
    if (status == PP_OK)
        fputs(pp_rad_functions_cal_text(), out);
    return status;
}
