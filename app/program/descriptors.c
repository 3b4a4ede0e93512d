/* Before the runtime system starts: what the caller closed or ignored.

   Descriptors 0, 1 and 2 that the caller closed are opened again, on the null device. Otherwise the next file or pipe
   opened would become the standard output, the runtime's own pipes first, and the program would hang. A closed input is
   then as empty; of a closed output every write fails, as it should, because it is opened for reading; what is said to a
   closed standard error is lost, as its caller wished.

   Which signals the caller ignored is kept, because the runtime system handles SIGINT without looking. */
#ifndef _WIN32
#include <fcntl.h>
#include <signal.h>
#include <stddef.h>

static sigset_t ignored;

__attribute__((constructor)) static void reopen_closed_descriptors(void)
{
    const int direction[3] = { O_RDONLY, O_RDONLY, O_WRONLY };
    for (int descriptor = 0; descriptor < 3; descriptor++)
        if (fcntl(descriptor, F_GETFD) == -1)
            (void) !open("/dev/null", direction[descriptor]);
}

__attribute__((constructor)) static void keep_ignored_signals(void)
{
    sigemptyset(&ignored);
    for (int number = 1; number < NSIG; number++) {
        struct sigaction found;
        if (sigaction(number, NULL, &found) == 0 && found.sa_handler == SIG_IGN)
            sigaddset(&ignored, number);
    }
}

int ignored_by_caller(int number)
{
    return sigismember(&ignored, number) == 1;
}
#endif
