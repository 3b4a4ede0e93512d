/* Before the runtime system starts: descriptors 0, 1 and 2 that the caller closed are opened again, on the null device.
   Otherwise the next file or pipe opened would become the standard output, the runtime's own pipes first, and the program
   would hang. A closed input is then as empty; of a closed output every write fails, as it should, because it is opened
   for reading; what is said to a closed standard error is lost, as its caller wished. */
#ifndef _WIN32
#include <fcntl.h>

__attribute__((constructor)) static void reopen_closed_descriptors(void)
{
    const int direction[3] = { O_RDONLY, O_RDONLY, O_WRONLY };
    for (int descriptor = 0; descriptor < 3; descriptor++)
        if (fcntl(descriptor, F_GETFD) == -1)
            (void) !open("/dev/null", direction[descriptor]);
}
#endif
