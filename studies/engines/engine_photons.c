/* engine_photons.c - adapts the photon simulation (simulate/research/photons) as an
 * engine. */
#include "simulate/research/photons/photons.h"
#include "studies/engines/engine.h"
#include "studies/engines/scattering_panes.h"

static enum pp_status create_photon_engine(void **run,
                                           const struct pp_light_scene *scene,
                                           const struct pp_environment *environment,
                                           const struct pp_report *report,
                                           const struct pp_engine_options *options,
                                           struct pp_error *err)
{
    enum pp_status able = pp_scattering_panes_refuse(report->world, "photons", err);
    if (able != PP_OK)
        return able;
    const struct pp_photons_options wanted = {.error = options->error,
                                              .samples = options->samples,
                                              .seed = options->seed,
                                              .threads = options->threads,
                                              .average = true,
                                              .sensor_m = options->sensor_m};
    struct pp_photons *solver;
    enum pp_status status =
        pp_photons_create(&solver, scene, environment, report->receivers,
                          report->receiver_count, &wanted, err);
    if (status == PP_OK)
        *run = solver;
    return status;
}

static enum pp_status advance_photon_engine(void *run, double seconds,
                                            struct pp_error *err)
{
    return pp_photons_advance(run, seconds, err);
}

static bool photon_engine_done(const void *run)
{
    return pp_photons_done(run);
}

static double photon_engine_progress(const void *run)
{
    return pp_photons_progress(run);
}

static double photon_engine_error(const void *run)
{
    return pp_photons_error(run);
}

static void read_photon_engine(const void *run, int index,
                               struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_photons_read(run, index, readings);
}

static double common(const void *run)
{
    return pp_photons_common(run);
}

static double common_near(const void *run)
{
    return pp_photons_common_near(run);
}

static void destroy_photon_engine(void *run)
{
    pp_photons_destroy(run);
}

const struct pp_engine pp_engine_photons = {
    .name = "photons",
    .column = "photons",
    .summary = "light paths from the openings, unbiased",
    .said = "by photons from the openings",
    .deviation = "one standard error",
    .from = "from photons, %",
    .is_truth = true,
    .is_sampled = true,
    .create = create_photon_engine,
    .advance = advance_photon_engine,
    .done = photon_engine_done,
    .progress = photon_engine_progress,
    .error = photon_engine_error,
    .read = read_photon_engine,
    .common = common,
    .common_near = common_near,
    .destroy = destroy_photon_engine,
};
