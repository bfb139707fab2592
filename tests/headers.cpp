// A program for the headers that the tests read once for all (cmake/build_time.cmake).
int main() {}
