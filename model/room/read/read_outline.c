/* read_outline.c - see read_outline.h. */
#include "model/room/read/read_outline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/pictures/sky_picture_view.h"

/* Greatest altitude of a point; a plane up to the zenith would have no end. */
static const double ALTITUDE_MOST_RAD = 88.0 * PP_RAD;

/* Greatest difference between the bearings of successive points. */
static const double STEP_MOST_RAD = 60.0 * PP_RAD;

enum { FILE_BYTES_MOST = 4 << 20, LINE_MOST = 200 };

/* ---- lines ---- */

/* Reads two numbers that are separated by a comma, a semicolon or white space. */
static bool read_pixel(char *line, double pixel[2])
{
    char *rest = line + strcspn(line, ",;\t "), *second;
    if (*rest == '\0')
        return false;
    second = rest + 1 + strspn(rest + 1, ",;\t ");
    *rest = '\0';
    return pp_text_parse_number(line, &pixel[0])
           && pp_text_parse_number(second, &pixel[1]);
}

/* ---- faces ---- */

/* The state of reading. */
struct outline_state {
    struct pp_mesh_triangles *mesh;
    const struct pp_sky_frame *frame;
    double distance_m;
    struct pp_vec3 last; /* top of the last point */
    int points;          /* of this outline */
};

/* Top of the obstruction in a direction, not below the horizon. */
static struct pp_vec3 top_of(struct pp_vec3 to, double distance_m)
{
    double level = hypot(to.x, to.y), up = to.z > 1e-9 ? to.z : 0.0;
    return pp_vec_scale(pp_vec(to.x, to.y, up), distance_m / level);
}

/* Adds the face between two tops and the horizon; nothing if both are at the horizon
 * or one is above the other. */
static const char *add_face(struct pp_mesh_triangles *mesh, struct pp_vec3 a,
                            struct pp_vec3 b)
{
    const struct pp_vec3 corners[4] = {pp_vec(a.x, a.y, 0.0), pp_vec(b.x, b.y, 0.0), b,
                                       a};
    int face[4], count = 0;
    if (!(hypot(a.x - b.x, a.y - b.y) > 1e-9) || !(a.z + b.z > 0.0))
        return NULL;
    for (int i = 0; i < 4; i++) {
        if (i >= 2 && !(corners[i].z > 0.0))
            continue;
        const char *why = pp_mesh_triangles_add_corner(mesh, corners[i]);
        if (why)
            return why;
        face[count++] = mesh->corner_count - 1;
    }
    return pp_mesh_triangles_add_face(mesh, face, count);
}

static enum pp_status add_to_outline(struct outline_state *outline, struct pp_vec3 to,
                                     struct pp_error *err)
{
    if (!(to.z < sin(ALTITUDE_MOST_RAD)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the point is %.1f degrees above the horizon; expected at most "
                       "%.0f",
                       asin(fmin(1.0, to.z)) / PP_RAD, ALTITUDE_MOST_RAD / PP_RAD);
    if (!(hypot(to.x, to.y) > cos(ALTITUDE_MOST_RAD)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the point is under the camera; expected points near the "
                       "horizon or above it");
    struct pp_vec3 top = top_of(to, outline->distance_m), last = outline->last;
    const char *why = NULL;
    if (outline->points > 0) {
        double step = atan2(fabs(last.x * top.y - last.y * top.x),
                            last.x * top.x + last.y * top.y);
        if (step > STEP_MOST_RAD)
            return pp_fail(err, PP_BAD_INPUT,
                           "the point is %.0f degrees of bearing from the point "
                           "before; expected at most %.0f",
                           step / PP_RAD, STEP_MOST_RAD / PP_RAD);
        why = add_face(outline->mesh, last, top);
    }
    outline->last = top;
    outline->points++;
    if (why == pp_mesh_triangles_no_memory)
        return pp_fail_memory(err);
    return why ? pp_fail(err, PP_BAD_INPUT, "the outline %s", why) : PP_OK;
}

/* ---- a text ---- */

static enum pp_status end_outline(struct outline_state *outline, struct pp_error *err)
{
    int points = outline->points;
    outline->points = 0;
    return points == 1 ? pp_fail(err, PP_BAD_INPUT,
                                 "the outline has one point; expected two or more")
                       : PP_OK;
}

/* Reads a line: a point, an empty line, a comment, or headings in the first line. */
static enum pp_status read_line(struct outline_state *outline, char *line, int number,
                                struct pp_error *err)
{
    double pixel[2];
    struct pp_vec3 to;
    char shown[64];
    line += strspn(line, " \t\r");
    if (*line == '#')
        return PP_OK;
    if (*line == '\0')
        return end_outline(outline, err);
    pp_text_excerpt(shown, sizeof shown, line);
    if (!read_pixel(line, pixel)) {
        bool headings = number == 1 && strpbrk(shown, "0123456789") == NULL;
        return headings ? PP_OK
                        : pp_fail(err, PP_BAD_INPUT,
                                  "\"%s\" is no point; expected two numbers of pixels, "
                                  "such as 812,340",
                                  shown);
    }
    if (!pp_sky_picture_direction(outline->frame, pixel[0], pixel[1], &to))
        return pp_fail(err, PP_BAD_INPUT,
                       "the point \"%s\" is outside the circle of the picture; "
                       "expected points within it",
                       shown);
    return add_to_outline(outline, to, err);
}

enum pp_status pp_read_outline_parse(struct pp_mesh_triangles *mesh, const char *text,
                                     size_t text_length, const char *title,
                                     const struct pp_sky_frame *frame,
                                     double distance_m, struct pp_error *err)
{
    struct outline_state outline = {
        .mesh = mesh, .frame = frame, .distance_m = distance_m};
    enum pp_status status = PP_OK;
    struct pp_error fault;
    const char *end = text + text_length;
    int number = 0;
    while (status == PP_OK && *text) {
        char line[LINE_MOST];
        size_t length = strcspn(text, "\n");
        number++;
        snprintf(line, sizeof line, "%.*s", (int)fmin((double)length, LINE_MOST - 1.0),
                 text);
        status = read_line(&outline, line, number, &fault);
        text += length + (text[length] == '\n');
    }
    if (status == PP_OK && text < end)
        status = pp_fail(&fault, PP_BAD_INPUT,
                         "there is a NUL byte; expected a list of points");
    if (status == PP_OK)
        status = end_outline(&outline, &fault);
    if (status == PP_OK && mesh->triangle_count == 0)
        status = pp_fail(&fault, PP_BAD_INPUT,
                         "the file has no outline above the horizon; expected points "
                         "along the edge of obstructions");
    return status == PP_OK
               ? PP_OK
               : pp_fail(err, status, "%s:%d: %s", title, number, fault.message);
}

void pp_read_outline_stand(struct pp_mesh_triangles *mesh, double z)
{
    for (int i = 0; i < mesh->corner_count && z < 0.0; i++)
        if (!(mesh->corners[i].z > 0.0))
            mesh->corners[i].z = z;
}

/* ---- the element ---- */

static enum pp_status lens_of(struct pp_sky_frame *frame,
                              const struct pp_outline_form *form, struct pp_error *err)
{
    enum { WIDE = 1000000 }; /* pixels; the size of the picture is not known */
    struct pp_sky_picture_options options = pp_sky_picture_options_none();
    enum pp_status status = PP_OK;
    for (int i = 0; i < PP_OUTLINE_FORM_OPTIONS && status == PP_OK; i++)
        if (form->picture[i])
            status = pp_sky_picture_options_set(&options, pp_sky_form_keys[i],
                                                form->picture[i], err);
    if (status == PP_OK && options.projection == PP_SKY_LATITUDE_LONGITUDE)
        return pp_fail(err, PP_BAD_INPUT,
                       "projection is \"latitude-longitude\"; expected equidistant, "
                       "equisolid or hemispherical");
    return status == PP_OK ? pp_sky_picture_view(frame, WIDE, WIDE, "", &options, err)
                           : status;
}

static enum pp_status read_points(struct pp_mesh_triangles *mesh, const char *path,
                                  const struct pp_sky_frame *frame, double distance_m,
                                  struct pp_error *err)
{
    char *bytes;
    size_t length;
    enum pp_status status =
        pp_read_file_regular(&bytes, &length, path, FILE_BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    const char *text = bytes + (strncmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0);
    if (length > FILE_BYTES_MOST)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: the file is larger than %d MB; expected a list of points",
                         path, FILE_BYTES_MOST >> 20);
    else
        status = pp_read_outline_parse(mesh, text, (size_t)(bytes + length - text),
                                       path, frame, distance_m, err);
    free(bytes);
    return status;
}

/* The faces of the outline; NULL after a mistake. */
static struct pp_shared_mesh *faces_of(struct pp_reader *r,
                                       const struct pp_outline_form *form, int line)
{
    struct pp_sky_frame frame = {0};
    struct pp_error fault = {0};
    enum pp_status status = lens_of(&frame, form, &fault);
    if (status == PP_OK && !r->folder)
        status = pp_fail(&fault, PP_BAD_INPUT,
                         "the room was not read from a file, so the file of its "
                         "outline cannot be located; expected a room read from a file");
    struct pp_shared_mesh *shared = calloc(1, sizeof *shared);
    char *path = status == PP_OK ? pp_reader_path(r, form->file) : NULL;
    if (status == PP_OK)
        status = shared && path ? read_points(&shared->mesh, path, &frame,
                                              form->distance_m, &fault)
                                : pp_fail_memory(&fault);
    free(path);
    if (status == PP_OK) {
        shared->holders = 1;
        return shared;
    }
    pp_mistakes_add(r->mistakes, line, "outline: %s", fault.message);
    if (shared)
        pp_mesh_triangles_clear(&shared->mesh);
    free(shared);
    return NULL;
}

void pp_read_outline(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e)
{
    struct pp_outline_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_outline, e))
        return;
    struct pp_shared_mesh *faces = faces_of(r, &form, e->line);
    if (!faces || !PP_READER_RESERVE(r, room->meshes, room->mesh_count)) {
        if (faces)
            pp_mesh_triangles_clear(&faces->mesh);
        free(faces);
        r->bad_elements++;
        return;
    }
    room->meshes[room->mesh_count++] =
        (struct pp_mesh_part){.file = faces,
                              .path = pp_reader_copy_text(r, form.file),
                              .name = pp_reader_copy_text(r, form.name),
                              .corner = pp_vec(form.x, form.y, form.z),
                              .scale = 1.0,
                              .is_outline = true,
                              .reflectance = form.finish.reflectance,
                              .finish = form.finish.finish,
                              .state = (enum pp_site_state)form.state,
                              .line = e->line};
}
