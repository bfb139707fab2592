// A program that provides the precompiled headers shared by all tests (cmake/build_time.cmake).
int main() {}
