/* mirror_image.c - see mirror_image.h. */
#include "model/room/outside/mirror_image.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

/* Unit direction of the line. */
static struct pp_vec3 direction(const struct pp_mirror_line *line)
{
    return pp_vec_unit(
        pp_vec(line->to[0] - line->from[0], line->to[1] - line->from[1], 0.0));
}

static struct pp_vec3 mirror(const struct pp_mirror_line *line, struct pp_vec3 p)
{
    struct pp_vec3 d = direction(line);
    double x = p.x - line->from[0], y = p.y - line->from[1];
    double along = 2.0 * (d.x * x + d.y * y);
    return pp_vec(line->from[0] + along * d.x - x, line->from[1] + along * d.y - y,
                  p.z);
}

void pp_mirror_image_sides(double sides_m[2], const struct pp_room_shell *shell,
                           const struct pp_mirror_line *line)
{
    struct pp_vec3 d = direction(line);
    sides_m[0] = sides_m[1] = 0.0;
    for (int i = 0; i < shell->body->face_count; i++) {
        const struct pp_polygon *face = &shell->body->surfaces[i].outline;
        for (int k = 0; k < face->count; k++) {
            double x = face->vertices[k].x - line->from[0];
            double y = face->vertices[k].y - line->from[1];
            double left = d.x * y - d.y * x;
            sides_m[0] = fmax(sides_m[0], left);
            sides_m[1] = fmax(sides_m[1], -left);
        }
    }
}

/* Mirrors the corners and reverses their order, so that the normal is mirrored too. */
static void mirror_corners(struct pp_vec3 *corners, const struct pp_vec3 *list,
                           int count, const struct pp_mirror_line *line)
{
    for (int i = 0; i < count; i++)
        corners[count - 1 - i] = mirror(line, list[i]);
}

static enum pp_status mirror_body(struct pp_room_shell *image,
                                  const struct pp_room_shell *shell,
                                  const struct pp_mirror_line *line,
                                  struct pp_error *err)
{
    const struct pp_world *body = shell->body;
    image->body->surfaces =
        calloc((size_t)body->face_count + 1, sizeof *image->body->surfaces);
    image->is_divided = calloc((size_t)body->face_count + 1, sizeof *image->is_divided);
    if (!image->body->surfaces || !image->is_divided)
        return pp_fail_memory(err);
    for (int i = 0; i < body->face_count; i++) {
        const struct pp_polygon *face = &body->surfaces[i].outline;
        struct pp_polygon *mirrored = &image->body->surfaces[i].outline;
        if (pp_polygon_of(mirrored, face->vertices, face->count, err) != PP_OK)
            return PP_SYSTEM;
        image->body->face_count = image->body->surface_count = i + 1;
        mirror_corners(mirrored->vertices, face->vertices, face->count, line);
        pp_polygon_measure(mirrored);
        image->body->surfaces[i].back = body->surfaces[i].back;
        image->is_divided[i] = shell->is_divided[i];
    }
    return PP_OK;
}

/* Adds the mirror image of one polygon; it belongs to no room. */
static enum pp_status carry(struct pp_room_shell *image,
                            const struct pp_surface_part *part,
                            const struct pp_vec3 *corners, int count,
                            const struct pp_mirror_line *line, struct pp_error *err)
{
    struct pp_surface_part unnamed = *part;
    struct pp_room_carried added = {0};
    unnamed.name = NULL;
    enum pp_status status =
        pp_room_parts_copy_surface(&added.part, &unnamed, corners, count, err);
    if (status != PP_OK)
        return status;
    mirror_corners(added.part.vertices.list, corners, count, line);
    status = pp_array_append(&image->carried, image->carried_count,
                             sizeof *image->carried, err);
    if (status == PP_OK)
        image->carried[image->carried_count++] = added;
    else
        pp_room_parts_clear_surface(&added.part);
    return status;
}

static enum pp_status mirror_front(struct pp_room_shell *image,
                                   const struct pp_room_front *front,
                                   const struct pp_mirror_line *line,
                                   struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_surface_part part = pp_room_front_part(front);
    struct pp_region_pieces pieces;
    enum pp_status status = pp_room_front_cut(&pieces, front, clipper, err);
    for (int i = 0; i < pieces.count && status == PP_OK; i++)
        status = carry(image, &part, pieces.list[i].corners, pieces.list[i].count, line,
                       err);
    pp_region_pieces_clear(&pieces);
    return status;
}

enum pp_status pp_mirror_image_make(struct pp_room_shell *image,
                                    const struct pp_room_shell *shell,
                                    const struct pp_mirror_line *line,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    *image = (struct pp_room_shell){.body = calloc(1, sizeof *image->body)};
    if (!image->body)
        return pp_fail_memory(err);
    enum pp_status status = mirror_body(image, shell, line, err);
    for (int i = 0; i < shell->front_count && status == PP_OK; i++)
        status = mirror_front(image, &shell->fronts[i], line, clipper, err);
    for (int i = 0; i < shell->carried_count && status == PP_OK; i++) {
        const struct pp_surface_part *part = &shell->carried[i].part;
        if (part->is_room_outside)
            status = carry(image, part, part->vertices.list, part->vertices.count, line,
                           err);
    }
    return status;
}
