from setuptools import setup

package_name = 'ros2_wall_avoider'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        ('share/' + package_name + '/launch', ['launch/wall_avoider.launch.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='pongsim maintainers',
    maintainer_email='maintainers@pongsim.org',
    description='Drives a robot with a lidar ahead, and turns it where a wall is near.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': ['wall_avoider = ros2_wall_avoider.wall_avoider:main'],
    },
)
