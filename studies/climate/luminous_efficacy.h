/* luminous_efficacy.h - luminous efficacy (lm/W) of the diffuse light from the sky.
 *
 * Model of the diffuse illuminance by Perez and others [PISMS90]:
 *
 *     v = a + b W + c cos Z + d ln D                                    (1)
 *
 *     e = ((Ed + En)/Ed + 1.041 Z^3)/(1 + 1.041 Z^3)    clearness, chooses a to d
 *     D = Ed m/E0                                       brightness
 *     m = 1/(cos Z + 0.15 (93.885 - Z)^-1.253)          air mass, Z in degrees [KAS66]
 *     W = exp(0.07 Td - 0.075)                          precipitable water, cm
 *
 *     Ed  diffuse irradiance of a horizontal plane, W/m2
 *     En  direct irradiance of a plane perpendicular to the sun, W/m2
 *     E0  1367 W/m2 over the squared distance of the sun in astronomical units
 *     Z   zenith angle of the sun; in radians, except in m
 *     Td  dew point, degrees Celsius
 *
 * According to its authors, the model predicts diffuse illuminances within 5 % (rms, of
 * measured means). Values are limited to 60 to 250 lm/W. The model exceeds these limits
 * only for irradiances that do not occur.
 */
#ifndef PP_STUDIES_CLIMATE_LUMINOUS_EFFICACY_H
#define PP_STUDIES_CLIMATE_LUMINOUS_EFFICACY_H

/* Returns v in (1), lm/W. diffuse_w_m2 > 0; direct_w_m2 >= 0; zenith angle 0 to pi/2;
 * dew point in degrees Celsius. */
double pp_luminous_efficacy_diffuse(double diffuse_w_m2, double direct_w_m2,
                                    double sun_zenith_rad, double sun_distance_au,
                                    double dew_point_c);

#endif
