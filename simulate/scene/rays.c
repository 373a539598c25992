/* rays.c - triangles and round shapes in a scene of Embree, and rays sent through
 * it. */
#include "config.h"

#include "simulate/scene/rays.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_EMBREE4
/* Embree's headers declare functions without a prototype. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wstrict-prototypes"
#include <embree4/rtcore.h>
#pragma GCC diagnostic pop
#else
#include <embree3/rtcore.h>
#endif

#include "simulate/scene/round.h"

struct pp_rays {
    RTCDevice device;
    RTCScene scene;
    struct pp_shape *rounds;
    unsigned round_geometry; /* Embree's id of the round shapes */
    int triangle_count;
    float low[3], high[3]; /* bounds of all shapes; low > high if there are none */
};

/* Converts Embree's last error. */
static enum pp_status embree_failed(const struct pp_rays *rays, struct pp_error *err)
{
    enum RTCError code = rtcGetDeviceError(rays->device);
    if (code == RTC_ERROR_OUT_OF_MEMORY)
        return pp_fail_memory(err);
    return pp_fail(err, PP_SYSTEM,
                   "Embree, which traces the rays, failed with error %d; the processor "
                   "may be too old for it",
                   (int)code);
}

static enum pp_status attach_triangles(struct pp_rays *rays,
                                       const float (*triangles)[3][3], int count,
                                       struct pp_error *err)
{
    RTCGeometry mesh = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!mesh)
        return embree_failed(rays, err);
    float *vertices =
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), (size_t)count * 3);
    unsigned *indices =
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), (size_t)count);
    if (vertices && indices) {
        memcpy(vertices, triangles, (size_t)count * sizeof *triangles);
        for (unsigned i = 0; i < 3u * (unsigned)count; i++)
            indices[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(rays->scene, mesh);
    }
    rtcReleaseGeometry(mesh);
    if (!vertices || !indices)
        return embree_failed(rays, err);
    return PP_OK;
}

/* Rounds towards minus infinity, so that a box is not made smaller. */
static float rounded_down(double x)
{
    return nextafterf((float)x, -INFINITY);
}

static float rounded_up(double x)
{
    return nextafterf((float)x, INFINITY);
}

static void round_bounds(const struct RTCBoundsFunctionArguments *asked)
{
    const struct pp_shape *rounds = asked->geometryUserPtr;
    struct pp_bounds3 box = pp_round_bounds(&rounds[asked->primID]);
    *asked->bounds_o = (struct RTCBounds){.lower_x = rounded_down(box.low.x),
                                          .lower_y = rounded_down(box.low.y),
                                          .lower_z = rounded_down(box.low.z),
                                          .upper_x = rounded_up(box.high.x),
                                          .upper_y = rounded_up(box.high.y),
                                          .upper_z = rounded_up(box.high.z)};
}

static void round_intersect(const struct RTCIntersectFunctionNArguments *asked)
{
    const struct pp_shape *rounds = asked->geometryUserPtr;
    struct RTCRayHit *query = (struct RTCRayHit *)asked->rayhit;
    double t;
    if (!asked->valid[0]
        || !pp_round_meet(&rounds[asked->primID],
                          pp_vec(query->ray.org_x, query->ray.org_y, query->ray.org_z),
                          pp_vec(query->ray.dir_x, query->ray.dir_y, query->ray.dir_z),
                          query->ray.tnear, query->ray.tfar, &t))
        return;
    query->ray.tfar = (float)t;
    query->hit.geomID = asked->geomID;
    query->hit.primID = asked->primID;
}

static enum pp_status attach_rounds(struct pp_rays *rays, const struct pp_shape *rounds,
                                    int count, struct pp_error *err)
{
    rays->rounds = malloc((size_t)count * sizeof *rounds);
    if (!rays->rounds)
        return pp_fail_memory(err);
    memcpy(rays->rounds, rounds, (size_t)count * sizeof *rounds);
    RTCGeometry geometry = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_USER);
    if (!geometry)
        return embree_failed(rays, err);
    rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)count);
    rtcSetGeometryUserData(geometry, rays->rounds);
    rtcSetGeometryBoundsFunction(geometry, round_bounds, NULL);
    rtcSetGeometryIntersectFunction(geometry, round_intersect);
    rtcCommitGeometry(geometry);
    rays->round_geometry = rtcAttachGeometry(rays->scene, geometry);
    rtcReleaseGeometry(geometry);
    return PP_OK;
}

enum pp_status pp_rays_create(struct pp_rays **result, const float (*triangles)[3][3],
                              int count, const struct pp_shape *rounds, int round_count,
                              struct pp_error *err)
{
    *result = NULL;
    struct pp_rays *rays = calloc(1, sizeof *rays);
    if (!rays)
        return pp_fail_memory(err);
    rays->triangle_count = count;
    rays->round_geometry = RTC_INVALID_GEOMETRY_ID;
    enum pp_status status = PP_OK;
    rays->device = rtcNewDevice("threads=1,set_affinity=0");
    if (!rays->device) {
        status = embree_failed(rays, err);
        goto failed;
    }
    rays->scene = rtcNewScene(rays->device);
    if (!rays->scene) {
        status = embree_failed(rays, err);
        goto failed;
    }
    rtcSetSceneFlags(rays->scene, RTC_SCENE_FLAG_ROBUST);
    if (count > 0)
        status = attach_triangles(rays, triangles, count, err);
    if (status == PP_OK && round_count > 0)
        status = attach_rounds(rays, rounds, round_count, err);
    if (status != PP_OK)
        goto failed;
    rtcCommitScene(rays->scene);
    if (rtcGetDeviceError(rays->device) != RTC_ERROR_NONE) {
        status = pp_fail_memory(err);
        goto failed;
    }
    struct RTCBounds bounds;
    rtcGetSceneBounds(rays->scene, &bounds);
    const float low[] = {bounds.lower_x, bounds.lower_y, bounds.lower_z};
    const float high[] = {bounds.upper_x, bounds.upper_y, bounds.upper_z};
    memcpy(rays->low, low, sizeof low);
    memcpy(rays->high, high, sizeof high);
    *result = rays;
    return PP_OK;
failed:
    pp_rays_destroy(rays);
    return status;
}

void pp_rays_destroy(struct pp_rays *rays)
{
    if (!rays)
        return;
    if (rays->scene)
        rtcReleaseScene(rays->scene);
    if (rays->device)
        rtcReleaseDevice(rays->device);
    free(rays->rounds);
    free(rays);
}

/* True if the ray starts beyond a side of the bounds and does not lead back. Most rays
 * from the ground to the sun do so; this test takes less time than the ray kernels. */
static bool leads_away(const struct pp_rays *rays, const float origin[3],
                       const float direction[3])
{
    for (int k = 0; k < 3; k++)
        if ((origin[k] > rays->high[k] && direction[k] >= 0.0f)
            || (origin[k] < rays->low[k] && direction[k] <= 0.0f))
            return true;
    return false;
}

int pp_rays_first(const struct pp_rays *rays, const float origin[3],
                  const float direction[3], float *distance)
{
    if (leads_away(rays, origin, direction))
        return -1;
    struct RTCRayHit query = {
        .ray = {.org_x = origin[0],
                .org_y = origin[1],
                .org_z = origin[2],
                .dir_x = direction[0],
                .dir_y = direction[1],
                .dir_z = direction[2],
                .tfar = INFINITY,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID}};
#ifdef HAVE_EMBREE4
    rtcIntersect1(rays->scene, &query, NULL);
#else
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(rays->scene, &context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return -1;
    *distance = query.ray.tfar;
    return (int)query.hit.primID
           + (query.hit.geomID == rays->round_geometry ? rays->triangle_count : 0);
}
