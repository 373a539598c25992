/* photon_counter.h - a sensor of finite size that counts photons: a disc, or the whole
 * working plane.
 *
 * A photon that crosses the sensor from its front adds flux / area and continues
 * unaffected. The sum is the mean irradiance over the sensor, without connections or
 * limits. Light reflected by mirrors and panes is counted like any other light.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_COUNTER_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_COUNTER_H

#include "simulate/research/photons/photon.h"

struct pp_photon_counter {
    struct pp_vec3 point, normal;         /* point of the sensor's plane; normal of its
                                           * front */
    double area_m2;                       /* 0: there is no counter */
    double radius_m;                      /* radius of a disc about the point; 0: not
                                           * a disc */
    const struct pp_vec3 (*triangles)[3]; /* not owned */
    int triangle_count;
};

struct pp_photon_counter pp_photon_counter_disc(struct pp_vec3 point,
                                                struct pp_vec3 normal, double radius_m);

/* The working plane of the scene's world. */
struct pp_photon_counter pp_photon_counter_plane(const struct pp_light_scene *scene);

/* Irradiance added by a photon on its way to photon->hit, or to nothing. */
double pp_photon_counter_takes(const struct pp_photon_counter *counter,
                               const struct pp_photon *photon);

#endif
