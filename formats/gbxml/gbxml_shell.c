/* gbxml_shell.c - welds corners by tolerance, pairs edges by their two corners. */
#include "formats/gbxml/gbxml_shell.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/polygon.h"

enum { FACES_MOST = 1000, CORNERS_MOST = 5000 };

void pp_gbxml_shell_clear(struct pp_gbxml_shell *shell)
{
    for (int i = 0; i < shell->face_count; i++)
        free(shell->faces[i].corners);
    free(shell->faces);
    free(shell->corners);
    *shell = (struct pp_gbxml_shell){0};
}

struct pp_vec3 pp_gbxml_shell_normal(const struct pp_gbxml_shell *shell, int index)
{
    const struct pp_gbxml_face *face = &shell->faces[index];
    struct pp_vec3 sum = {0.0, 0.0, 0.0}, first = shell->corners[face->corners[0]];
    for (int i = 1; i + 1 < face->count; i++) {
        struct pp_vec3 a = pp_vec_sub(shell->corners[face->corners[i]], first);
        struct pp_vec3 b = pp_vec_sub(shell->corners[face->corners[i + 1]], first);
        sum = pp_vec_add(sum, pp_vec_cross(a, b));
    }
    return sum;
}

/* ---- corners ---- */

/* Finds the nearest corner within the tolerance, or adds a corner. */
static enum pp_status find_corner(int *index, struct pp_gbxml_shell *shell,
                                  struct pp_vec3 at, struct pp_error *err)
{
    double least = shell->weld_m;
    *index = -1;
    for (int i = 0; i < shell->corner_count; i++) {
        double away = pp_vec_length(pp_vec_sub(shell->corners[i], at));
        if (away < least)
            *index = i, least = away;
    }
    if (*index >= 0) {
        shell->moved_m = fmax(shell->moved_m, least);
        return PP_OK;
    }
    enum pp_status status = pp_array_append(&shell->corners, shell->corner_count,
                                            sizeof *shell->corners, err);
    if (status == PP_OK) {
        *index = shell->corner_count;
        shell->corners[shell->corner_count++] = at;
    }
    return status;
}

/* Removes repeated corners, and spikes (a, b, a). */
static void tidy(struct pp_gbxml_face *face)
{
    for (int i = 0; i < face->count && face->count >= 3;) {
        int *c = face->corners, n = face->count;
        int next = (i + 1) % n, beyond = (i + 2) % n;
        int out = c[i] == c[next] || c[i] == c[beyond] ? next : -1;
        if (out < 0) {
            i++;
            continue;
        }
        memmove(c + out, c + out + 1, (size_t)(n - out - 1) * sizeof *c);
        face->count--;
        i = 0;
    }
}

static enum pp_status add_shell_face(struct pp_gbxml_shell *shell,
                                     const struct pp_gbxml_polygon *polygon, int from,
                                     struct pp_error *err)
{
    struct pp_gbxml_face face = {.from = from};
    face.corners = calloc((size_t)polygon->count + 1, sizeof *face.corners);
    if (!face.corners)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    struct pp_vec3 moves = {0.0, 0.0, 0.0};
    for (int i = 0; i < polygon->count && status == PP_OK; i++) {
        struct pp_vec3 at = polygon->corners[i];
        status = find_corner(&face.corners[face.count], shell, at, err);
        if (status == PP_OK)
            moves = pp_vec_add(
                moves, pp_vec_sub(shell->corners[face.corners[face.count++]], at));
    }
    shell->moved_m3 += fabs(pp_vec_dot(moves, pp_polygon_area_vector(polygon->corners,
                                                                     polygon->count)))
                       / polygon->count;
    tidy(&face);
    if (status == PP_OK && face.count >= 3)
        status = pp_array_append(&shell->faces, shell->face_count, sizeof *shell->faces,
                                 err);
    if (status != PP_OK || face.count < 3) {
        free(face.corners);
        return status;
    }
    shell->faces[shell->face_count++] = face;
    return PP_OK;
}

/* Position of a corner along the edge from a to b; NAN if it does not lie on the
 * edge. */
static double along_edge(const struct pp_gbxml_shell *shell, int a, int b, int corner)
{
    struct pp_vec3 way = pp_vec_sub(shell->corners[b], shell->corners[a]);
    struct pp_vec3 to = pp_vec_sub(shell->corners[corner], shell->corners[a]);
    double length = pp_vec_length(way), along = pp_vec_dot(to, way) / length;
    if (corner == a || corner == b || !(along > 0.0 && along < length))
        return NAN;
    struct pp_vec3 foot = pp_vec_scale(way, along / length);
    return pp_vec_length(pp_vec_sub(to, foot)) < shell->weld_m ? along : NAN;
}

/* Inserts corners that lie on the face's edges. A sliver that collapses has no corners
 * afterwards. */
static enum pp_status divide_edges(struct pp_gbxml_shell *shell,
                                   struct pp_gbxml_face *face, struct pp_error *err)
{
    for (int i = 0; i < face->count;) {
        int a = face->corners[i], b = face->corners[(i + 1) % face->count],
            nearest = -1;
        double least = INFINITY;
        for (int k = 0; k < shell->corner_count; k++) {
            double along = along_edge(shell, a, b, k);
            if (along < least) {
                least = along;
                nearest = k;
            }
        }
        if (nearest < 0) {
            i++;
            continue;
        }
        int *grown = realloc(face->corners, ((size_t)face->count + 1) * sizeof *grown);
        if (!grown)
            return pp_fail_memory(err);
        face->corners = grown;
        memmove(grown + i + 2, grown + i + 1,
                (size_t)(face->count - i - 1) * sizeof *grown);
        grown[i + 1] = nearest;
        face->count++;
        if (face->count > CORNERS_MOST)
            break;
        i++;
    }
    tidy(face);
    if (face->count < 3)
        face->count = 0;
    return PP_OK;
}

/* True if the face has no corners, or an earlier face has the same ones in any
 * order. */
static bool is_double(const struct pp_gbxml_shell *shell, int index)
{
    const struct pp_gbxml_face *face = &shell->faces[index];
    if (face->count == 0)
        return true;
    for (int i = 0; i < index; i++) {
        const struct pp_gbxml_face *other = &shell->faces[i];
        int shared = 0;
        for (int k = 0; k < face->count && other->count == face->count; k++)
            for (int m = 0; m < other->count; m++)
                shared += other->corners[m] == face->corners[k];
        if (other->count == face->count && shared >= face->count)
            return true;
    }
    return false;
}

static void drop_doubles(struct pp_gbxml_shell *shell)
{
    for (int i = 0; i < shell->face_count;) {
        if (!is_double(shell, i)) {
            i++;
            continue;
        }
        free(shell->faces[i].corners);
        memmove(&shell->faces[i], &shell->faces[i + 1],
                (size_t)(shell->face_count - i - 1) * sizeof *shell->faces);
        shell->face_count--;
    }
}

/* ---- edges ---- */

struct shell_edge {
    int low, high; /* indices of its corners */
    int face;
    bool forward; /* true if the face runs from low to high */
};

struct shell_edges {
    struct shell_edge *list;
    int count;
};

static int by_corners(const void *a, const void *b)
{
    const struct shell_edge *one = a, *other = b;
    if (one->low != other->low)
        return one->low < other->low ? -1 : 1;
    if (one->high != other->high)
        return one->high < other->high ? -1 : 1;
    return (one->face > other->face) - (one->face < other->face);
}

/* Lists the edges of all faces, sorted so that equal edges are adjacent. */
static enum pp_status list_edges(struct shell_edges *edges,
                                 const struct pp_gbxml_shell *shell,
                                 struct pp_error *err)
{
    size_t most = 1;
    for (int i = 0; i < shell->face_count; i++)
        most += (size_t)shell->faces[i].count;
    *edges = (struct shell_edges){calloc(most, sizeof *edges->list), 0};
    if (!edges->list)
        return pp_fail_memory(err);
    for (int i = 0; i < shell->face_count; i++) {
        const struct pp_gbxml_face *face = &shell->faces[i];
        for (int k = 0; k < face->count; k++) {
            int a = face->corners[k], b = face->corners[(k + 1) % face->count];
            edges->list[edges->count++] =
                (struct shell_edge){a < b ? a : b, a < b ? b : a, i, a < b};
        }
    }
    qsort(edges->list, (size_t)edges->count, sizeof *edges->list, by_corners);
    return PP_OK;
}

/* Number of edges with the same corners, beginning with `at`. */
static int count_same(const struct shell_edges *edges, int at)
{
    int count = 1;
    while (at + count < edges->count
           && edges->list[at + count].low == edges->list[at].low
           && edges->list[at + count].high == edges->list[at].high)
        count++;
    return count;
}

/* Joins loose edges (edges of only one face) into a loop that begins with edge `at`,
 * and sets `face` of these edges to -1. The loop's count is 0 if they do not form a
 * loop; its corners are NULL if memory runs out. */
static struct pp_gbxml_face take_loop(struct shell_edges *loose, int at)
{
    struct pp_gbxml_face loop = {.from = -1};
    loop.corners = calloc((size_t)loose->count + 1, sizeof *loop.corners);
    if (!loop.corners)
        return loop;
    int first = loose->list[at].low, here = loose->list[at].high;
    loose->list[at].face = -1;
    loop.corners[loop.count++] = first;
    while (here != first) {
        int next = -1, found = 0;
        for (int i = 0; i < loose->count; i++)
            if (loose->list[i].face >= 0
                && (loose->list[i].low == here || loose->list[i].high == here)) {
                next = i;
                found++;
            }
        if (found != 1) {
            loop.count = 0;
            return loop;
        }
        loop.corners[loop.count++] = here;
        here = loose->list[next].low == here ? loose->list[next].high
                                             : loose->list[next].low;
        loose->list[next].face = -1;
    }
    return loop;
}

static bool is_plane(const struct pp_gbxml_shell *shell, int index)
{
    const struct pp_gbxml_face *face = &shell->faces[index];
    struct pp_vec3 normal = pp_gbxml_shell_normal(shell, index);
    double length = pp_vec_length(normal);
    for (int i = 0; i < face->count && length > 0.0; i++) {
        struct pp_vec3 from = pp_vec_sub(shell->corners[face->corners[i]],
                                         shell->corners[face->corners[0]]);
        if (fabs(pp_vec_dot(from, normal)) / length > shell->weld_m)
            return false;
    }
    return length > 0.0;
}

/* Closes planar holes. *why as in pp_gbxml_shell_make. */
static enum pp_status close_holes(struct pp_gbxml_shell *shell, const char **why,
                                  struct shell_edges *edges, struct pp_error *err)
{
    struct shell_edges loose = {calloc((size_t)edges->count + 1, sizeof *loose.list),
                                0};
    enum pp_status status = loose.list ? PP_OK : pp_fail_memory(err);
    for (int i = 0, same; i < edges->count && status == PP_OK; i += same) {
        same = count_same(edges, i);
        if (same > 2)
            *why = "has edges where more than two of its surfaces meet";
        if (same == 1)
            loose.list[loose.count++] = edges->list[i];
    }
    for (int i = 0; i < loose.count && status == PP_OK && !*why; i++) {
        if (loose.list[i].face < 0)
            continue;
        struct pp_gbxml_face loop = take_loop(&loose, i);
        if (!loop.corners)
            status = pp_fail_memory(err);
        else if (loop.count >= 3)
            status = pp_array_append(&shell->faces, shell->face_count,
                                     sizeof *shell->faces, err);
        if (loop.count < 3 || status != PP_OK) {
            free(loop.corners);
            *why = "is not closed";
            break;
        }
        shell->faces[shell->face_count++] = loop;
        shell->lacking++;
        if (!is_plane(shell, shell->face_count - 1))
            *why = "is not closed, and the gap is not planar";
    }
    free(loose.list);
    return status;
}

static void turn_gbxml_face(struct pp_gbxml_face *face)
{
    for (int i = 0, k = face->count - 1; i < k; i++, k--) {
        int kept = face->corners[i];
        face->corners[i] = face->corners[k];
        face->corners[k] = kept;
    }
}

/* Orients the faces so that neighbours traverse their common edge in opposite
 * directions, beginning with the first face. *why: set if there are several pieces, or
 * no such orientation exists. */
static enum pp_status turn_alike(struct pp_gbxml_shell *shell, const char **why,
                                 struct pp_error *err)
{
    struct shell_edges edges;
    enum pp_status status = list_edges(&edges, shell, err);
    if (status != PP_OK)
        return status;
    signed char *turned =
        calloc((size_t)shell->face_count + 1, 1); /* 0: not yet known */
    bool goes_on = turned != NULL;
    if (turned)
        turned[0] = 1;
    while (goes_on && !*why) {
        goes_on = false;
        for (int i = 0; i + 1 < edges.count; i += 2) {
            const struct shell_edge *a = &edges.list[i], *b = &edges.list[i + 1];
            int way = a->forward != b->forward ? 1 : -1;
            if (turned[a->face] && turned[b->face]) {
                if (turned[a->face] * turned[b->face] != way)
                    *why = "has twisted surfaces";
            } else if (turned[a->face] || turned[b->face]) {
                if (turned[a->face])
                    turned[b->face] = (signed char)(turned[a->face] * way);
                else
                    turned[a->face] = (signed char)(turned[b->face] * way);
                goes_on = true;
            }
        }
    }
    for (int i = 0; i < shell->face_count && turned; i++) {
        if (!turned[i])
            *why = "consists of several separate pieces";
        if (turned[i] < 0)
            turn_gbxml_face(&shell->faces[i]);
    }
    status = turned ? PP_OK : pp_fail_memory(err);
    free(turned);
    free(edges.list);
    return status;
}

/* Turns all faces inwards. With inward normals the signed volume, a sixth of the sum,
 * is negative. */
static void turn_inwards(struct pp_gbxml_shell *shell)
{
    double volume = 0.0;
    for (int i = 0; i < shell->face_count; i++)
        volume += pp_vec_dot(
            pp_gbxml_shell_normal(shell, i),
            pp_vec_sub(shell->corners[shell->faces[i].corners[0]], shell->corners[0]));
    for (int i = 0; i < shell->face_count && volume > 0.0; i++)
        turn_gbxml_face(&shell->faces[i]);
    shell->volume_m3 = fabs(volume) / 6.0;
}

double pp_gbxml_shell_floor_area(const struct pp_gbxml_shell *shell)
{
    double area = 0.0;
    for (int i = 0; i < shell->face_count; i++) {
        struct pp_vec3 normal = pp_gbxml_shell_normal(shell, i);
        if (normal.z > 0.5 * pp_vec_length(normal))
            area += 0.5 * normal.z;
    }
    return area;
}

enum pp_status pp_gbxml_shell_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double weld_m, struct pp_error *err)
{
    struct shell_edges edges = {0};
    enum pp_status status = PP_OK;
    *shell = (struct pp_gbxml_shell){.weld_m = weld_m};
    *why = count < 4            ? "has fewer than four surfaces"
           : count > FACES_MOST ? "has more than 1000 surfaces"
                                : NULL;
    for (int i = 0; i < count && status == PP_OK && !*why; i++) {
        status = add_shell_face(shell, &polygons[i], i, err);
        if (shell->corner_count > CORNERS_MOST)
            *why = "has more than 5000 corners";
    }
    for (int i = 0; i < shell->face_count && status == PP_OK && !*why; i++)
        status = divide_edges(shell, &shell->faces[i], err);
    if (status != PP_OK || *why)
        return status;
    drop_doubles(shell);
    if (shell->face_count < 4) {
        *why = "has fewer than four surfaces";
        return PP_OK;
    }
    status = list_edges(&edges, shell, err);
    if (status == PP_OK)
        status = close_holes(shell, why, &edges, err);
    free(edges.list);
    if (status == PP_OK && !*why)
        status = turn_alike(shell, why, err);
    if (status == PP_OK && !*why)
        turn_inwards(shell);
    return status;
}
