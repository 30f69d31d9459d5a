/// The name of the present machine, printed beside measurements.
#ifndef BALLOON_LAB_RUN_MACHINE_H
#define BALLOON_LAB_RUN_MACHINE_H

/// CPU and compiler: "AMD EPYC 9654, gcc 12.2.0". Valid until the next call.
const char* machine_name(void);

#endif
