/* engine_photons.c - the photons of simulate/research/photons as an engine. */
#include <stdlib.h>

#include "simulate/research/photons/photons.h"
#include "studies/engines/engine.h"

/* The light on the scene, and its photons. */
struct photon_run {
    struct pp_environment *environment;
    struct pp_photons *photons;
};

static void destroy_photon_engine(void *data)
{
    struct photon_run *run = data;
    if (!run)
        return;
    pp_photons_destroy(run->photons);
    pp_environment_destroy(run->environment);
    free(run);
}

static enum pp_status make_photon_run(struct photon_run *run,
                                      const struct pp_light_scene *scene,
                                      const struct pp_report *report,
                                      const struct pp_engine_options *options,
                                      struct pp_error *err)
{
    const struct pp_photons_options wanted = {.error = options->error,
                                              .samples = options->samples,
                                              .seed = options->seed,
                                              .threads = options->threads,
                                              .average = true,
                                              .sensor_m = options->sensor_m};
    enum pp_status status =
        pp_light_scene_under(&run->environment, scene, &report->light, err);
    if (status == PP_OK)
        status =
            pp_photons_create(&run->photons, scene, run->environment, report->receivers,
                              report->receiver_count, &wanted, err);
    return status;
}

static enum pp_status create_photon_engine(void **data,
                                           const struct pp_light_scene *scene,
                                           const struct pp_report *report,
                                           const struct pp_engine_options *options,
                                           struct pp_error *err)
{
    struct photon_run *run = calloc(1, sizeof *run);
    if (!run)
        return pp_fail_memory(err);
    enum pp_status status = make_photon_run(run, scene, report, options, err);
    if (status != PP_OK) {
        destroy_photon_engine(run);
        run = NULL;
    }
    *data = run;
    return status;
}

static enum pp_status advance_photon_engine(void *data, double seconds,
                                            struct pp_error *err)
{
    struct photon_run *run = data;
    return pp_photons_advance(run->photons, seconds, err);
}

static bool photon_engine_done(const void *data)
{
    const struct photon_run *run = data;
    return pp_photons_done(run->photons);
}

static double photon_engine_progress(const void *data)
{
    const struct photon_run *run = data;
    return pp_photons_progress(run->photons);
}

static double photon_engine_error(const void *data)
{
    const struct photon_run *run = data;
    return pp_photons_error(run->photons);
}

static void read_photon_engine(const void *data, int index,
                               struct pp_reading readings[PP_COMPONENT_COUNT])
{
    const struct photon_run *run = data;
    pp_photons_read(run->photons, index, readings);
}

static double common(const void *data)
{
    const struct photon_run *run = data;
    return pp_photons_common(run->photons);
}

static double common_near(const void *data)
{
    const struct photon_run *run = data;
    return pp_photons_common_near(run->photons);
}

const struct pp_engine pp_engine_photons = {
    .name = "photons",
    .column = "photons",
    .summary = "light followed forwards from the openings, without bias",
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
