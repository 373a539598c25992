/* section.c - see section.h.
 *
 * The plane cuts each face along segments. A segment begins where the face's outline
 * crosses the plane upwards and ends where the outline crosses the plane downwards.
 * With the room on the left, segments traverse the section counter-clockwise and its
 * holes clockwise. A segment ends on an edge shared by two faces, where the segment of
 * the other face begins. Corners in the plane count as below the plane, so the result
 * is the section just above the plane.
 */
#include "model/room/section.h"

#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"
#include "model/geometry/tolerance.h"

/* Edge of a face that crosses the plane. */
struct plane_crossing {
    int low, high;   /* numbers of its corners below and above the plane */
    bool upward;     /* the face traverses it upwards */
    double position; /* position along the section of the face */
    double xy[2];
};

struct segment {
    struct plane_crossing from, to;
    bool used;
};

struct plane_section {
    struct segment *segments;
    int count, space;
};

static struct plane_crossing crossing_of(struct pp_vec3 low, struct pp_vec3 high,
                                         double z)
{
    double t = (z - low.z) / (high.z - low.z);
    return (struct plane_crossing){
        .xy = {low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)}};
}

/* Finds the crossings of a face, in order along the direction that has the room on its
 * left. Returns their number, which is even. */
static int face_crossings(struct plane_crossing *crossings,
                          const struct pp_polygon *face, const int *corners, double z)
{
    int count = 0;
    struct pp_vec3 n = face->normal;
    for (int i = 0; i < face->count; i++) {
        int next = (i + 1) % face->count;
        struct pp_vec3 p = face->vertices[i], q = face->vertices[next];
        if ((p.z > z) == (q.z > z))
            continue;
        bool upward = q.z > z;
        struct plane_crossing crossing =
            upward ? crossing_of(p, q, z) : crossing_of(q, p, z);
        crossing.low = corners[upward ? i : next];
        crossing.high = corners[upward ? next : i];
        crossing.upward = upward;
        crossing.position = n.y * crossing.xy[0] - n.x * crossing.xy[1];
        int k = count++;
        for (; k > 0 && crossings[k - 1].position > crossing.position; k--)
            crossings[k] = crossings[k - 1];
        crossings[k] = crossing;
    }
    /* Upward and downward crossings alternate, even if two coincide. */
    for (int i = 0; i + 1 < count; i++)
        if (crossings[i].upward != (i % 2 == 0)) {
            struct plane_crossing swap = crossings[i];
            crossings[i] = crossings[i + 1];
            crossings[i + 1] = swap;
        }
    return count;
}

static enum pp_status add_segment(struct plane_section *section,
                                  struct plane_crossing from, struct plane_crossing to,
                                  struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&section->segments, &section->space, section->count + 1,
                         sizeof *section->segments, err);
    if (status != PP_OK)
        return status;
    section->segments[section->count++] = (struct segment){from, to, false};
    return PP_OK;
}

static enum pp_status cut_faces(struct plane_section *section,
                                const struct pp_world *world, const int *corners,
                                double z, struct pp_error *err)
{
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        struct plane_crossing *crossings = malloc(face->count * sizeof *crossings);
        if (!crossings)
            return pp_fail_memory(err);
        int count = face_crossings(crossings, face, corners, z);
        enum pp_status status = PP_OK;
        for (int k = 0; k + 1 < count && status == PP_OK; k += 2)
            status = add_segment(section, crossings[k], crossings[k + 1], err);
        free(crossings);
        if (status != PP_OK)
            return status;
        corners += face->count;
    }
    return PP_OK;
}

static int compare_segments(const void *left, const void *right)
{
    const struct plane_crossing *a = &((const struct segment *)left)->from;
    const struct plane_crossing *b = &((const struct segment *)right)->from;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->high > b->high) - (a->high < b->high);
}

static struct segment *segment_from(const struct plane_section *section,
                                    struct plane_crossing end)
{
    struct segment key = {.from = end};
    return bsearch(&key, section->segments, section->count, sizeof key,
                   compare_segments);
}

/* Appends a ring to the region, without repeated points; a ring without area is left
 * out. */
static enum pp_status add_section_ring(struct pp_region *region, const double (*xy)[2],
                                       int count, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&region->rings, region->count, sizeof *region->rings, err);
    if (status != PP_OK)
        return status;
    struct pp_ring ring = {.xy = malloc(count * sizeof *ring.xy)};
    if (!ring.xy)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        const double *before = ring.count > 0 ? ring.xy[ring.count - 1] : xy[count - 1];
        if (hypot(xy[i][0] - before[0], xy[i][1] - before[1]) < PP_ROUNDING_M)
            continue;
        ring.xy[ring.count][0] = xy[i][0];
        ring.xy[ring.count++][1] = xy[i][1];
    }
    if (ring.count < 3)
        free(ring.xy);
    else
        region->rings[region->count++] = ring;
    return PP_OK;
}

/* Follows the segments from face to face until each ring closes. */
static enum pp_status join_segments(struct pp_region *region,
                                    struct plane_section *section, struct pp_error *err)
{
    double(*xy)[2] = malloc((section->count + 1) * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < section->count && status == PP_OK; i++) {
        int count = 0;
        for (struct segment *segment = &section->segments[i]; segment && !segment->used;
             segment = segment_from(section, segment->to)) {
            segment->used = true;
            xy[count][0] = segment->from.xy[0];
            xy[count++][1] = segment->from.xy[1];
        }
        if (count >= 3)
            status = add_section_ring(region, (const double(*)[2])xy, count, err);
    }
    free(xy);
    return status;
}

/* Sorts the rings: outer rings, each followed by its holes. */
static enum pp_status sort_rings(struct pp_region *region, struct pp_error *err)
{
    struct pp_ring *sorted = malloc((region->count + 1) * sizeof *sorted);
    if (!sorted)
        return pp_fail_memory(err);
    int count = 0;
    for (int i = 0; i < region->count; i++) {
        const struct pp_ring *outer = &region->rings[i];
        if (pp_region_ring_area((const double(*)[2])outer->xy, outer->count) <= 0.0)
            continue;
        sorted[count++] = *outer;
        for (int k = 0; k < region->count; k++) {
            struct pp_ring *hole = &region->rings[k];
            if (hole->count == 0
                || pp_region_ring_area((const double(*)[2])hole->xy, hole->count) > 0.0
                || pp_polygon_ring_side((const double(*)[2])outer->xy, outer->count,
                                        hole->xy[0][0], hole->xy[0][1], 0.0)
                       == PP_OUTSIDE)
                continue;
            sorted[count++] = *hole;
            hole->count = 0;
        }
    }
    free(region->rings);
    region->rings = sorted;
    region->count = count;
    return PP_OK;
}

enum pp_status pp_section_cut(struct pp_region *region, const struct pp_world *world,
                              const int *corners, double z, struct pp_error *err)
{
    struct plane_section section = {0};
    enum pp_status status = cut_faces(&section, world, corners, z, err);
    if (status == PP_OK && section.count > 0) {
        qsort(section.segments, section.count, sizeof *section.segments,
              compare_segments);
        status = join_segments(region, &section, err);
    }
    if (status == PP_OK)
        status = sort_rings(region, err);
    free(section.segments);
    return status;
}

/* Corner of a face; corners with equal coordinates get the same number. */
struct corner {
    struct pp_vec3 place;
    int at; /* index in the list of all faces' vertices */
};

static int compare_corners(const void *left, const void *right)
{
    struct pp_vec3 a = ((const struct corner *)left)->place;
    struct pp_vec3 b = ((const struct corner *)right)->place;
    return a.x != b.x   ? (a.x > b.x) - (a.x < b.x)
           : a.y != b.y ? (a.y > b.y) - (a.y < b.y)
                        : (a.z > b.z) - (a.z < b.z);
}

/* Numbers the corners. Corners with exactly equal coordinates get the same number,
 * since faces that meet share corners exactly. */
static void number_corners(int *numbers, struct corner *corners,
                           const struct pp_world *world)
{
    int count = 0, number = 0;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++, count++)
            corners[count] =
                (struct corner){world->surfaces[i].outline.vertices[k], count};
    qsort(corners, count, sizeof *corners, compare_corners);
    for (int i = 0; i < count; i++) {
        number += i > 0 && compare_corners(&corners[i - 1], &corners[i]) != 0;
        numbers[corners[i].at] = number;
    }
}

enum pp_status pp_section_at(struct pp_region *region, const struct pp_world *world,
                             double z, struct pp_error *err)
{
    *region = (struct pp_region){0};
    int count = 0;
    for (int i = 0; i < world->face_count; i++)
        count += world->surfaces[i].outline.count;
    int *numbers = malloc((count + 1) * sizeof *numbers);
    struct corner *corners = malloc((count + 1) * sizeof *corners);
    enum pp_status status = numbers && corners ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        number_corners(numbers, corners, world);
        status = pp_section_cut(region, world, numbers, z, err);
    }
    free(numbers);
    free(corners);
    if (status != PP_OK)
        pp_region_clear(region);
    return status;
}

static enum pp_status take_away(struct pp_region *region, struct pp_clipper *clipper,
                                const struct pp_fitting *fitting, struct pp_error *err)
{
    struct pp_region cut = {0};
    enum pp_status status = pp_clipper_of_ring(
        clipper, &cut, (const double(*)[2])fitting->xy, fitting->corner_count, err);
    if (status == PP_OK)
        status = pp_clipper_take_away(clipper, region, &cut, err);
    pp_region_clear(&cut);
    return status;
}

bool pp_section_meets(const struct pp_world *world, const struct pp_fitting *fitting)
{
    return world->working_plane_m > fitting->low_m
           && world->working_plane_m < fitting->high_m;
}

enum pp_status pp_section_open(struct pp_region *region, const struct pp_world *world,
                               struct pp_error *err)
{
    struct pp_clipper *clipper;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status != PP_OK)
        return status;
    pp_clipper_set_grid(clipper, 1e-9); /* avoids slivers along sloping walls */
    status = pp_region_copy(region, &world->plane, err);
    for (int i = 0; status == PP_OK && i < world->fitting_count; i++)
        if (pp_section_meets(world, &world->fittings[i]))
            status = take_away(region, clipper, &world->fittings[i], err);
    pp_clipper_destroy(clipper);
    if (status == PP_OK && region->count == 0)
        status = pp_region_copy(region, &world->plane, err);
    if (status != PP_OK)
        pp_region_clear(region);
    return status;
}
